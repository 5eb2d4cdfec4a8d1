#include "validate/compare/difference_code.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lumaknot::validate {
namespace {

TEST(DifferenceCode, is_right_to_half_a_step_near_zero_and_to_4_5_percent_beyond) {
  for (const double step : {kFinestStep, 1.0 / 64}) {
    for (double d = step / 100; d < 100 * step; d *= 1.01) {
      for (const double difference : {d, -d}) {
        const double error =
            std::abs(decoded_difference(difference_code(difference, step), step) - difference);
        // Half the distance of two codes, kCodeBend in asinh's range, with its curvature.
        EXPECT_LE(error, std::max(0.505 * step, 0.0463 * d + 0.5 * step)) << difference;
      }
    }
  }
}

TEST(DifferenceCode, nothing_below_half_a_step_is_kept) {
  EXPECT_EQ(difference_code(0.49 * kFinestStep, kFinestStep), 0);
  EXPECT_EQ(difference_code(0.51 * kFinestStep, kFinestStep), 1);
  EXPECT_EQ(difference_code(-0.51 * kFinestStep, kFinestStep), -1);
}

TEST(DifferenceCode, keeps_differences_up_to_seven_and_limits_larger_ones) {
  EXPECT_GT(decoded_difference(127, kFinestStep), 7);
  EXPECT_EQ(difference_code(1e9, kFinestStep), 127);
  EXPECT_EQ(difference_code(-1e9, kFinestStep), -127);
}

/// Differences everywhere, which no file holds in few bytes.
Grid<Rgb> noise(float amplitude) {
  std::mt19937 random(1);
  const auto next = [&] {
    return amplitude * (float(random()) / float(std::mt19937::max()) - 0.5f);
  };
  Grid<Rgb> grid(64, 64);
  for (Rgb& p : grid.pixels) p = {next(), next(), next()};
  return grid;
}

TEST(CodedDifferences, a_tight_budget_is_met_by_a_coarser_step) {
  const Grid<Rgb> grid = noise(0.01f);
  const CodedDifference fine = coded_differences(grid, 1 << 20);
  EXPECT_EQ(fine.step, kFinestStep);
  const CodedDifference coarse = coded_differences(grid, fine.png.size() / 2);
  EXPECT_GT(coarse.step, fine.step);
  EXPECT_LE(coarse.png.size(), fine.png.size() / 2);
}

TEST(CodedDifferences, a_budget_that_no_step_meets_by_far_is_met_by_blocks) {
  const std::size_t whole = coded_differences(noise(1), 1 << 20).png.size();
  const CodedDifference above = coded_differences(noise(1), whole / 5);
  EXPECT_EQ(above.step, 1.0 / 64);
  EXPECT_EQ(above.block, 1) << "four times the budget may be taken";
  const CodedDifference coarse = coded_differences(noise(1), whole / 40);
  EXPECT_GT(coarse.block, 1);
  EXPECT_LE(coarse.png.size(), whole / 10);
}

TEST(CodedDifferences, of_nothing_take_next_to_nothing) {
  EXPECT_LT(coded_differences(Grid<Rgb>(720, 720), 1 << 20).png.size(), 3000u);
}

}  // namespace
}  // namespace lumaknot::validate
