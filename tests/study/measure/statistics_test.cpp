#include "study/measure/statistics.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lumaknot::measure {
namespace {

TEST(Statistics, median_of_an_odd_number_is_the_middle_one) {
  EXPECT_EQ(median({5}), 5);
  EXPECT_EQ(median({9, 1, 4}), 4);
}

TEST(Statistics, median_of_an_even_number_is_the_mean_of_the_middle_two) {
  EXPECT_EQ(median({8, 2}), 5);
  EXPECT_EQ(median({1000, 3, 4, 1}), 3.5);
}

TEST(Statistics, spread_holds_the_minimum_and_the_maximum) {
  const std::vector<double> values{3, 1, 7, 2, 5};
  const Spread spread = spread_of(values);
  EXPECT_EQ(spread.median, 3);
  EXPECT_EQ(spread.min, 1);
  EXPECT_EQ(spread.max, 7);
}

TEST(Statistics, paired_ratio_does_not_see_that_the_machine_slows_down) {
  // Each pair has the ratio 1.25 while the machine becomes ten times slower; one pair is disturbed.
  const std::vector<double> below{1, 2, 4, 8, 10}, above{1.25, 2.5, 5, 80, 12.5};
  EXPECT_EQ(paired_ratio(above, below), 1.25);
}

TEST(Statistics, the_median_s_interval_is_that_of_tables_of_order_statistics) {
  // Ranks of the 95 % interval from the binomial distribution, as tables have them.
  const std::vector<std::pair<int, int>> ranks{{6, 1}, {9, 2}, {20, 6}, {50, 18}, {100, 40}};
  for (const auto& [count, rank] : ranks) {
    std::vector<double> values;
    for (int i = count; i > 0; --i) values.push_back(i);
    EXPECT_EQ(median_interval(values).min, rank) << count;
    EXPECT_EQ(median_interval(values).max, count + 1 - rank) << count;
  }
}

TEST(Statistics, of_fewer_than_six_values_the_median_may_lie_anywhere) {
  EXPECT_TRUE(std::isinf(median_interval({1, 1, 1, 1, 1}).min));
  EXPECT_TRUE(std::isinf(median_interval({}).max));
}

TEST(Statistics, a_time_is_shown_by_three_digits_and_never_fewer_before_the_point) {
  EXPECT_EQ(shown_time(0.021449), "0.0214");
  EXPECT_EQ(shown_time(0.99951), "1.00");
  EXPECT_EQ(shown_time(12.345), "12.3");
  EXPECT_EQ(shown_time(123456.7), "123457");
  EXPECT_EQ(shown_time(0), "0.00");
}

TEST(Statistics, a_share_is_shown_as_none_or_all_only_if_it_is) {
  EXPECT_EQ(shown_share(0), "0 %");
  EXPECT_EQ(shown_share(1), "100 %");
  EXPECT_EQ(shown_share(0.426), "42.6 %");
  EXPECT_EQ(shown_share(0.99973), "99.973 %");
  EXPECT_EQ(shown_share(1.0 / 518400), "0.00019 %");
  EXPECT_EQ(shown_share(518399.0 / 518400), "99.99981 %");
}

}  // namespace
}  // namespace lumaknot::measure
