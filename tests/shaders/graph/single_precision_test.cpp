// Every formula in float against double, within a bound derived from its steps.
#include <gtest/gtest.h>

#include "shaders/graph/record.h"
#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/graph/rounding_bound.h"
#include "tests/shaders/languages/every_shot.h"
#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

/// `v` rounded to float: inputs without error.
Vec3d as_float(const Vec3d& v) { return widened(narrowed<float>(v)); }

struct Point {
  SurfacePoint<double> surface;
  Vec3d texture;  ///< in the form of the material
};

Point random_point(RandomSurface& random, const Material& material) {
  const SurfacePoint<double> p = random.point();
  const Vec3d texture = as_float(random.texture());
  return {{as_float(p.position), as_float(p.normal)}, as_float(texture_value(texture, material))};
}

Vec3d in_float(const Point& p, const View& view, const Shot& shot) {
  const auto lighting = lighting_of<float>(view, shot.material);
  return widened(
      stage_color<float>({narrowed<float>(p.surface.position), narrowed<float>(p.surface.normal)},
                         narrowed<float>(p.texture), lighting, shot));
}

rounding::Inputs inputs_of(const Point& p, const Material& material) {
  return {{"position", p.surface.position},
          {"normal", p.surface.normal},
          {material.form == Form::kBaked ? "texture_axes" : "texture", p.texture}};
}

TEST(SinglePrecision, of_every_formula_stays_within_the_bound_of_its_steps) {
  RandomSurface random;
  double largest_error = 0;
  for (const NamedView& view : every_view()) {
    for (const Shot& shot : final_shots()) {
      const rounding::Tape tape = rounding::tape_of(record_shot(view.view, shot).color);
      for (int i = 0; i < 3; ++i) {
        const Point p = random_point(random, shot.material);
        const auto values = rounding::values_of(tape, inputs_of(p, shot.material));
        const Vec3d error = rounding::absolute(in_float(p, view.view, shot) - values.back());
        const Vec3d bound = rounding::rounding_bound<rounding::LibraryErrors>(tape, values);
        // 1e-7: second order, and the sRGB curve's pieces that meet within 3e-8.
        const Vec3d over = error - bound * 1.01;
        ASSERT_LT(largest_component(over), 1e-7) << view.name << ": " << shot.name;
        const double scale = std::max(1.0, largest_magnitude(values.back()));
        largest_error = std::max(largest_error, largest_magnitude(error) / scale);
      }
    }
  }
  // Of full scale, or of the value where it is larger: a shader's possible error.
  EXPECT_LT(largest_error, 2e-5);
  RecordProperty("largest_error_e9", int(largest_error * 1e9));
}

}  // namespace
}  // namespace lumaknot
