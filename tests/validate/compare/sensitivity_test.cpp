// Limits derived from a renderer's promise, with our own renderer playing the other.
#include "validate/compare/sensitivity.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "shaders/graph/half.h"
#include "tests/validate/small_scene.h"
#include "validate/compare/images.h"

namespace lumaknot::validate {
namespace {

using testing::final_shot;
using testing::small_scene;

constexpr Promise kFloat{.power_error = 1e-6, .reason = "float32 throughout"};

/// A scene, and what other renderers make of it.
struct Derived {
  Scene scene = small_scene(192);
  Grid<Fragment> fragments = visible_fragments(scene);
  Reference reference{scene, fragments};
  Shot shot = final_shot("yiq-eq6");
  Image ours = shade_all(scene, shot, fragments);

  Comparison judge(const Image& theirs, const Promise& promise = kFloat) const {
    return compare(reference, shot, ours, theirs, sensitivities(reference, shot),
                   {.promise = promise});
  }

  /// Our picture of fragments that each were changed.
  template <class F>
  Image changed(const F& change) const {
    Grid<Fragment> copy = fragments;
    for (int y = 0; y < copy.height; ++y) {
      for (int x = 0; x < copy.width; ++x) {
        if (copy.at(x, y).covered()) change(copy.at(x, y), x, y);
      }
    }
    return shade_all(scene, shot, copy);
  }

  /// The picture that lies aside by so many pixels.
  Image shifted(double dx, double dy) const {
    return changed([&](Fragment& f, int x, int y) {
      const Fragment seen = reference.probe.at(x + 0.5 - dx, y + 0.5 - dy);
      if (seen.covered()) f = seen;
    });
  }
};

Vec3d to_float(const Vec3d& v) { return {float(v.x), float(v.y), float(v.z)}; }

TEST(DerivedLimits, hold_for_float32_positions_normals_and_coordinates) {
  const Derived derived;
  const Comparison c = derived.judge(derived.changed([](Fragment& f, int, int) {
    f.position = to_float(f.position);
    f.normal = to_float(f.normal);
    f.uv = {float(f.uv.u), float(f.uv.v)};
  }));
  EXPECT_EQ(c.outcome(), Outcome::kAgreed);
  EXPECT_EQ(c.outliers, 0);
  EXPECT_GT(c.use.max, 0.01) << "and they are not beyond all measure";
}

TEST(DerivedLimits, notice_half_precision) {
  const Derived derived;
  Scene scene = derived.scene;
  scene.view.material = derived.shot.material;
  const Comparison c = derived.judge(render_in_half(scene));
  EXPECT_EQ(c.outcome(), Outcome::kDiffered);
  EXPECT_GT(c.outliers, c.covered / 2);
}

TEST(DerivedLimits, notice_half_floats_in_a_picture_alone) {
  const Derived derived;
  Image theirs = derived.ours;
  for (RgbaPixel& p : theirs.pixels) {
    p.color = {float(round_to_half(p.color.r)), float(round_to_half(p.color.g)),
               float(round_to_half(p.color.b))};
  }
  EXPECT_EQ(derived.judge(theirs).outcome(), Outcome::kDiffered);
  Promise half = kFloat;
  half.output_relative = kStepHalf;
  EXPECT_EQ(derived.judge(theirs, half).outcome(), Outcome::kAgreed) << "where it is promised";
}

TEST(DerivedLimits, notice_a_shift_by_a_512th_of_a_pixel) {
  const Derived derived;
  const Comparison c = derived.judge(derived.shifted(1.0 / 512, 0));
  EXPECT_EQ(c.outcome(), Outcome::kDiffered);
  EXPECT_NEAR(c.shift.x, 1.0 / 512, 1e-4) << "a twentieth of it";
  EXPECT_NEAR(c.shift.y, 0, 1e-4);
  const Comparison back = derived.judge(derived.shifted(0, -1.0 / 512));
  EXPECT_NEAR(back.shift.y, -1.0 / 512, 1e-4);
}

TEST(DerivedLimits, notice_a_shift_on_a_rasterisers_grid) {
  const Derived derived;
  Promise promise = kFloat;
  promise.grid_bits = 8;
  const Comparison c = derived.judge(derived.shifted(1.0 / 512, 1.0 / 512), promise);
  EXPECT_EQ(c.outcome(), Outcome::kDiffered) << "each sample is within the grid, all are not";
  EXPECT_THAT(c.exceeded, ::testing::Contains(::testing::StartsWith("shifted by (0.00")));
}

TEST(DerivedLimits, grow_with_what_is_promised) {
  const Derived derived;
  const Grid<Sensitivity> all = sensitivities(derived.reference, derived.shot);
  Promise coarse = kFloat;
  coarse.grid_bits = 8;
  coarse.snaps_shade = true;
  coarse.output_step = kStep16;
  coarse.texel_weight = 1.0 / 256;
  for (int y = 0; y < all.height; ++y) {
    for (int x = 0; x < all.width; ++x) {
      const double fine = limit_of(all.at(x, y), kFloat).sum();
      EXPECT_GT(fine, 0) << "even where nothing is covered";
      EXPECT_GE(limit_of(all.at(x, y), coarse).sum(), fine + kStep16 / 2);
    }
  }
}

TEST(DerivedLimits, of_a_picture_use_the_worst_pixels_parts) {
  const Derived derived;
  const Comparison c = derived.judge(derived.shifted(1e-4, 0));
  EXPECT_NEAR(c.use.error / c.use.limit.sum(), c.use.max, 1e-9) << "one and the same pixel";
  EXPECT_GT(c.use.limit.of[std::size_t(LimitPart::kSample)], 0);
  EXPECT_EQ(c.use.limit.of[std::size_t(LimitPart::kSnapped)], 0);
}

}  // namespace
}  // namespace lumaknot::validate
