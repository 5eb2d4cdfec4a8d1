// Quantiles of errors.
#include "validate/compare/quantile.h"

#include <gtest/gtest.h>

namespace lumaknot::validate {
namespace {

TEST(Quantile, is_the_smallest_value_that_the_share_does_not_exceed) {
  const std::vector<double> values{4, 1, 3, 2};
  EXPECT_EQ(quantile(values, 0.25), 1);
  EXPECT_EQ(quantile(values, 0.26), 2);
  EXPECT_EQ(quantile(values, 1), 4);
}

TEST(Quantile, is_zero_without_values) { EXPECT_EQ(quantile({}, 0.5), 0); }

}  // namespace
}  // namespace lumaknot::validate
