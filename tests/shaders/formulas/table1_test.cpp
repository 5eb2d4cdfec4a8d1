// The paper's Table 1, transcribed line by line from its HLSL, against our formulas.
#include <gtest/gtest.h>

#include "scene/presets.h"
#include "shaders/formulas/lighting.h"
#include "tests/shaders/formulas/random_surface.h"

namespace lumaknot {
namespace {

// HLSL's names and none of our functions except the vectors', so that the listing can be compared.
struct Float3 {
  double x, y, z;
};
double hlsl_dot(Float3 a, Float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double hlsl_saturate(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }
Float3 hlsl_saturate(Float3 a) {
  return {hlsl_saturate(a.x), hlsl_saturate(a.y), hlsl_saturate(a.z)};
}
Float3 hlsl_normalize(Float3 a) {
  const double size = std::sqrt(hlsl_dot(a, a));
  return {a.x / size, a.y / size, a.z / size};
}
Float3 minus(Float3 a, Float3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Float3 times(double s, Float3 a) { return {s * a.x, s * a.y, s * a.z}; }

// NOLINTBEGIN(readability-identifier-naming): as the listing has them
Float3 RGBtoYIQ(Float3 c) {
  Float3 out;
  out.y = 0.29889531 * c.x + 0.58662247 * c.y + 0.11448223 * c.z;
  out.x = 0.59597799 * c.x + -0.27417610 * c.y + -0.32180189 * c.z;
  out.z = 0.21147017 * c.x + -0.52261711 * c.y + 0.31114694 * c.z;
  return out;
}

Float3 YIQtoRGB(Float3 c) {
  Float3 out;
  out.x = c.y + 0.95608445 * c.x + 0.62088850 * c.z;
  out.y = c.y - 0.27137664 * c.x - 0.64860590 * c.z;
  out.z = c.y - 1.10561724 * c.x + 1.70250126 * c.z;
  return hlsl_saturate(out);
}

struct Parameters {
  Float3 eye_pos, light_pos;
  double ambient_value, specular_power;
};

Float3 LumaPhongDiffuse(Float3 normal_world, Float3 pos_world, Float3 tex_col, Parameters p) {
  const Float3 to_eye = hlsl_normalize(minus(p.eye_pos, pos_world));
  const Float3 light_vector = hlsl_normalize(minus(p.light_pos, pos_world));
  const Float3 reflection = hlsl_normalize(
      minus(times(2.0 * hlsl_dot(normal_world, light_vector), normal_world), light_vector));
  const double diffuse =
      hlsl_saturate(hlsl_saturate(hlsl_dot(light_vector, normal_world)) + p.ambient_value);
  const double specular = std::pow(hlsl_saturate(hlsl_dot(reflection, to_eye)), p.specular_power);
  Float3 work_col = RGBtoYIQ(tex_col);
  work_col.y = work_col.y * diffuse + specular * 1.0 - 0.1;
  return YIQtoRGB(work_col);
}
// NOLINTEND(readability-identifier-naming)

Float3 hlsl(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// The scene's numbers that Table 1 has, the weights at one.
View table1_view(RandomSurface& random) {
  View view = random.view();
  view.ambient = random.number(0, 1);
  return view;
}

Material table1_material(RandomSurface& random) {
  Material m = *with_formula(Material{}, "yiq-table1");
  m.parameters["shininess"] = random.number(0, 16);
  return m;
}

Parameters listing_parameters(const View& view, const Material& material) {
  return {hlsl(view.camera.position), hlsl(std::get<PointLight>(view.lights[0]).position),
          view.ambient, material.parameters["shininess"]};
}

TEST(Table1, preset_computes_the_listing) {
  RandomSurface random;
  int inside = 0;
  for (int i = 0; i < 500; ++i) {
    const SurfacePoint<double> point = random.point();
    const Vec3d texture = random.texture();
    const View view = table1_view(random);
    const Material m = table1_material(random);
    const Float3 expected = LumaPhongDiffuse(hlsl(point.normal), hlsl(point.position),
                                             hlsl(texture), listing_parameters(view, m));
    const Vec3d color =
        stage_color(point, texture, lighting_of<double>(view, m), {"table1", Stage::kFinal, m});
    // Rounding in another order, times an exponent of up to 16 and a chroma weight of 1.7.
    ASSERT_NEAR(color.x, expected.x, 1e-13) << i;
    ASSERT_NEAR(color.y, expected.y, 1e-13) << i;
    ASSERT_NEAR(color.z, expected.z, 1e-13) << i;
    for (const double c : components(color)) inside += c > 0 && c < 1;
  }
  EXPECT_GT(inside, 700);  // of 1500 channels: enough that no clamp hides
}

TEST(Table1, differs_from_the_equations_where_the_paper_does) {
  // One point where each of the listing's four differences shows.
  const SurfacePoint<double> point{{0, 0, 0}, {0, 0, 0.9}};
  const Vec3d texture{0.5, 0.4, 0.3};
  View view;
  view.camera.position = {0, 0, 3};
  view.lights = {PointLight{{0, 0, 5}, {}, {}}};
  view.ambient = 0.5;
  const auto color = [&](const char* formula) {
    const Material m = *with_formula(Material{}, formula);
    return stage_color(point, texture, lighting_of<double>(view, m), {"s", Stage::kFinal, m});
  };
  // Table 1: light saturates at 1, highlight 1: Y + 1 - 0.1 beyond white.
  EXPECT_EQ(color("yiq-table1"), (Vec3d{1, 1, 1}));
  // Eq. 6: Y_T (0.5 + 1) + 1, chroma kept: T + Y_T / 2 + 1 (M and W are inverse to 1e-7).
  const double y = 0.29889531 * 0.5 + 0.58662247 * 0.4 + 0.11448223 * 0.3;
  EXPECT_NEAR(color("yiq-eq6").x, 0.5 + y / 2 + 1, 1e-6);
  EXPECT_NEAR(color("yiq-eq6").z, 0.3 + y / 2 + 1, 1e-6);
}

}  // namespace
}  // namespace lumaknot
