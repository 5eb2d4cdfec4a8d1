#include "math/number.h"

#include <gtest/gtest.h>

namespace lumaknot {
namespace {

TEST(Number, saturate_keeps_the_unit_interval_and_its_ends) {
  EXPECT_EQ(saturate(-0.5), 0);
  EXPECT_EQ(saturate(0.0), 0);
  EXPECT_EQ(saturate(0.25), 0.25);
  EXPECT_EQ(saturate(1.0), 1);
  EXPECT_EQ(saturate(7.0), 1);
  EXPECT_EQ(saturate(Vec3d{-1, 0.5, 2}), (Vec3d{0, 0.5, 1}));
}

TEST(Number, unit_vectors_have_length_one_and_zero_stays_zero) {
  EXPECT_EQ(unit(Vec3d{0, 3, 4}), (Vec3d{0, 0.6, 0.8}));
  EXPECT_EQ(unit(Vec3d{0, 0, 0}), (Vec3d{0, 0, 0}));
  EXPECT_EQ(unit(Vec3<float>{0, 0, -2}), (Vec3<float>{0, 0, -1}));
}

TEST(Number, power_to_the_zeroth_is_one) {
  EXPECT_EQ(power(0.5, 0.0), 1);
  EXPECT_EQ(power(0.5, 2.0), 0.25);
  EXPECT_EQ(power(0.0, 55.0), 0);
}

TEST(Number, a_name_changes_no_value) {
  EXPECT_EQ(named("x", 0.1), 0.1);
  EXPECT_EQ(named("v", Vec3d{1, 2, 3}), (Vec3d{1, 2, 3}));
}

}  // namespace
}  // namespace lumaknot
