// Both sides of every boundary, each with a number of its own.
#include "study/stability/regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>

#include "math/angle.h"
#include "meshgen/clearance.h"
#include "study/stability/test_scenes.h"

namespace lumaknot::stability {
namespace {

/// A value where the method must hold and one where it must fail, near to each other, and why
/// there. Without a reason other than the measure, they are its own to a few per cent.
struct Sides {
  const char* region;
  double holds, fails;
};

/// So that tests are listed by names and not by bytes.
void PrintTo(const Sides& sides, std::ostream* out) { *out << sides.region; }

constexpr double kWhatFloatSquares = 1.8447e19;  // the root of its largest number

const Sides kSides[] = {
    {"frenet-inflection", 0.385, 0.375},
    {"fixed-up-vertical", 0.82, 0.84},
    {"naive-closing", 0.079, 0.083},
    {"finite-difference-frames", 13, 16},
    // Noise of 6e-8 in each coordinate over |C'| h, |C'| = 1.7 to 3.
    {"difference-step-short", 1.5e-6, 8e-7},
    {"difference-step-long", 0.0225, 0.0231},
    // Two strands pass 0.8 apart: mesh --strict refuses above 0.4. A millionth of the radius
    // deeper.
    {"tube-clearance", 0.4, 0.400001},
    {"strands-touch", 17, 21},
    // A chord of 384 / q per turn: 1 - cos(pi q / 384), about 0.4 of it by 0.03.
    {"many-turns", 13, 14},
    {"few-segments", 57, 52},
    // 1 - cos(pi / n) is 0.099 for 7 and 0.134 for 6.
    {"few-sides", 7, 6},
    {"grazing-normals", 10, 8},
    {"unnormalised-normal", 8, 5},
    {"light-at-vertices", 32, 25},
    {"texture-seam", 52, 40},
    // 2^24 / 512: from there on neighbours are two texels apart, and half of it is above 1/2.
    {"scrolled-texture-float", 32767, 32768},
    // Lengths of about 5.9.
    {"huge-coordinates-float", kWhatFloatSquares / 6.1, kWhatFloatSquares / 5.4},
    {"tiny-coordinates-float", 1e-21, 4e-22},
    {"offset-float", 6e4, 1.1e5},
    {"spot-edge-float", 0.02, 0.004},
    {"half-power", 45, 55},
    // Squares of half end at 65520, lengths of about 5.9 at 256 / 5.9.
    {"half-normalize-far", 42, 45},
    {"half-normalize-near", 1.2e-3, 8e-4},
    {"half-falloff-far", 255.9, 256},
    // 1 / d^2 < 65520.
    {"half-falloff-near", 0.003909, 0.003906},
    {"half-cieluv-dark", 2e-4, 1.5e-4},
    {"half-yiq-round-trip", 5, 6},
    // The lecture's hard boundary at shininess 1 and 2.
    {"phong-cutoff", 3, 2},
    {"highlight-behind", 130, 140},
    {"shininess-zero", 0.32, 0.27},
    // The smallest number of float is 1.4e-45; half of it is rounded to 0.
    {"power-zero-zero", 7.1e-46, 6.9e-46},
    {"shininess-float", 2e4, 4e4},
    {"shininess-sampling", 40, 100},
    // Squares below 7e-46 are zero, each coordinate's on its own.
    {"light-on-surface", 4.5e-23, 3.5e-23},
    {"light-near-surface", 0.72, 0.63},
    // (n.l)^(-1/2) = 10.5.
    {"light-at-eye", 1.001 / 110.25, 0.999 / 110.25},
    {"light-at-infinity", 0.999 * kWhatFloatSquares, 1.001 * kWhatFloatSquares},
    {"half-way-opposite", 1e-6, 4e-7},
    // The tube's radius is 0.18.
    {"eye-inside-tube", 0.19, 0.175},
    {"oren-nayar-from-above", 1e-3, 4e-4},
    {"cook-torrance-smooth", 0.045, 0.035},
    {"cook-torrance-grazing", 1.2e-17, 1e-17},
    {"clamp-dark-yiq", 0.55, 0.5},
    {"clamp-dark-yuv601", 0.55, 0.5},
    {"clamp-dark-yuv709", 0.56, 0.51},
    {"clamp-dark-cielab", 0.76, 0.7},
    {"clamp-dark-cieluv", 0.8, 0.74},
    {"clamp-dark-din99", 0.82, 0.76},
    {"clamp-dark-atd95", 0.83, 0.78},
    {"clamp-bright-rgb", 1.2, 1.25},
    {"clamp-bright-yiq", 1.27, 1.33},
    // M and W are inverse to each other to 1.5e-8 a pass.
    {"yiq-round-trip", 2.6e5, 2.8e5},
    {"energy-phong", 88.5, 88.9},
    {"energy-blinn-phong", 86.5, 86.8},
    // 2 / (k + 1).
    {"energy-minnaert", 1, 0.995},
    // 1 + w 2 / (k + 2), k = 10, above 1.001.
    {"energy-sum", 0.0058, 0.0062},
};

/// All regions once.
const std::map<std::string, Region>& regions() {
  static const std::map<std::string, Region> kRegions = [] {
    std::map<std::string, Region> all;
    for (const Region& region : all_regions()) all[region.name] = region;
    return all;
  }();
  return kRegions;
}

class Regions : public testing::TestWithParam<Sides> {
 protected:
  const Region& region() const { return regions().at(GetParam().region); }
};

TEST_P(Regions, method_holds_on_one_side_and_fails_on_the_other) {
  const double good = region().error(GetParam().holds), bad = region().error(GetParam().fails);
  EXPECT_TRUE(holds(region(), good)) << good;
  EXPECT_FALSE(holds(region(), bad)) << bad;
}

TEST_P(Regions, pictures_are_of_both_sides) {
  const Region& r = region();
  EXPECT_TRUE(holds(r, r.error(r.shown_holds.value_or(r.sweep.from))));
  EXPECT_FALSE(holds(r, r.error(r.shown_fails.value_or(r.sweep.to))));
}

TEST_P(Regions, remedy_holds_on_both_sides) {
  if (!region().guarded) return;
  for (const double x : {GetParam().holds, GetParam().fails}) {
    EXPECT_TRUE(holds(region(), region().guarded(x))) << x << ": " << region().guarded(x);
  }
}

TEST_P(Regions, remedy_draws_numbers_over_the_whole_sweep) {
  if (!region().guarded_sketch) return;
  for (const double x : swept_values(region().sweep, 4)) {
    for (const RgbaPixel& pixel : region().guarded_sketch(x, 16).pixels) {
      ASSERT_TRUE(is_finite(to_vec(pixel.color))) << x;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Regions, testing::ValuesIn(kSides), [](const auto& each) {
  std::string name = each.param.region;
  std::ranges::replace(name, '-', '_');
  return name;
});

/// Where the region's method stops holding.
Boundary boundary_of(const Region& region) {
  std::vector<Measured> sweep;
  for (const double x : swept_values(region.sweep, 40)) sweep.push_back({x, region.error(x)});
  return find_boundary(region, sweep);
}

TEST(TubeClearance, fails_where_the_command_that_makes_meshes_refuses) {
  const double refused = clearance(components(sketch_knot())).radius;
  const Boundary found = boundary_of(regions().at("tube-clearance"));
  // The measure's limit, a millionth of the radius, is half as much of it; the bisection leaves a
  // millionth of the sweep.
  EXPECT_NEAR(found.holds.x, refused, 1e-6);
  EXPECT_NEAR(found.fails.x, refused, 1e-6);
  EXPECT_NEAR(refused, 0.4, 1e-9);
}

TEST(PhongCutoff, measures_a_second_difference_by_its_formula_and_tells_the_exact_jump) {
  const Region& region = regions().at("phong-cutoff");
  const double h = 0.5 * kDegree;
  for (const double k : {1.8, 2.0, 2.2, 2.5, 3.0}) {
    const double formula = std::pow(h, k - 2) * (std::pow(2, k) - 2);
    EXPECT_NEAR(region.error(k), formula, 1e-3 * formula) << k;  // sin x = x up to x^2 / 6
  }
  const auto exact = [&](std::size_t i, double k) { return region.also[i].measure(k); };
  EXPECT_EQ(exact(0, 1), 1);  // the slope's
  EXPECT_EQ(exact(0, 1.5), 0);
  EXPECT_EQ(exact(1, 2), 2);  // the curvature's
  EXPECT_EQ(exact(1, 2.4), 0);
  EXPECT_EQ(exact(1, 3), 0);
  EXPECT_TRUE(std::isinf(exact(1, 1.5)));
}

TEST(PhongCutoff, fails_from_a_shininess_at_which_nothing_jumps) {
  const Region& region = regions().at("phong-cutoff");
  const Boundary found = boundary_of(region);
  EXPECT_GT(found.fails.x, 2);
  EXPECT_EQ(region.also[1].measure(found.fails.x), 0);
  EXPECT_NEAR(found.holds.error, region.limit, 1e-3);
}

TEST(RegionList, has_both_sides_of_each_and_words_for_it) {
  std::set<std::string> names;
  for (const Sides& sides : kSides) names.insert(sides.region);
  EXPECT_GE(names.size(), 25u);
  EXPECT_EQ(names.size(), all_regions().size());
  for (const Region& region : all_regions()) {
    EXPECT_TRUE(names.contains(region.name)) << region.name;
    for (const std::string* text : {&region.method, &region.reason, &region.remedy,
                                    &region.measured, &region.group, &region.sweep.parameter}) {
      EXPECT_FALSE(text->empty()) << region.name;
    }
  }
}

}  // namespace
}  // namespace lumaknot::stability
