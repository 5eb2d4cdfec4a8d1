#include "study/measure/method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "meshgen/knot_mesh.h"
#include "render/reference.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "study/chart/points.h"
#include "study/measure/method_words.h"
#include "system/error.h"

namespace lumaknot::measure {
namespace {

SceneSpec small_spec() {
  SceneSpec spec = *builtin_scene("figure2");
  auto& knot = std::get<KnotSpec>(spec.mesh);
  knot.segments = 96, knot.sides = 12;
  spec.view.image = {60, 48, 1};
  return spec;
}

Scene scene_of(const SceneSpec& spec) {
  return {knot_mesh(std::get<KnotSpec>(spec.mesh)), bricks(), spec.view};
}

/// The largest difference of a channel where both cover the pixel.
double apart(const Image& a, const Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (a.pixels[i].coverage != b.pixels[i].coverage) continue;
    const Vec3d d = to_vec(a.pixels[i].color) - to_vec(b.pixels[i].color);
    largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  return largest;
}

TEST(Method, has_a_name_of_its_own) {
  EXPECT_EQ(method_name({192, 10, ShadingFrequency::kPixel, Space::kYiq, Formula::kCollapsed,
                         Number::kFloat, Filter::kTrilinear, 4}),
            "192x10 pixel yiq-collapsed float trilinear 4x");
  EXPECT_EQ(method_name({0, 0, ShadingFrequency::kVertex, Space::kCielab, Formula::kMatrices,
                         Number::kHalf, Filter::kBilinear, 1}),
            "mesh vertex cielab half bilinear 1x");
}

TEST(Method, the_usual_ones_are_sixty_or_more_of_names_of_their_own_and_can_be_drawn) {
  const SceneSpec spec = *builtin_scene("figure2");
  const std::vector<Space> spaces{Space::kRgb, Space::kYiq};
  const std::vector<Method> all = chart::usual_methods(spec.mesh, bricks(), spaces);
  std::set<std::string> names;
  for (const Method& method : all) {
    EXPECT_EQ(method_shortfall(method), "");
    names.insert(method_name(method));
  }
  EXPECT_EQ(names.size(), all.size());
  EXPECT_GE(all.size(), 60u);
}

TEST(Method, those_of_a_mesh_file_keep_its_mesh) {
  const std::vector<Space> spaces{Space::kRgb};
  for (const Method& method : chart::usual_methods(MeshFile{"a.obj"}, Vec3d{1, 0, 0}, spaces)) {
    EXPECT_EQ(method.segments, 0);
  }
}

TEST(Method, what_can_t_be_drawn_is_reported) {
  const Scene scene = scene_of(small_spec());
  for (const Method& method :
       {Method{.space = Space::kCielab, .formula = Formula::kCollapsed},
        Method{.space = Space::kRgb, .formula = Formula::kBaked},
        Method{.space = Space::kRgb, .formula = Formula::kTable1}, Method{.samples = 3},
        Method{.number = Number::kDouble},
        Method{.number = Number::kDouble, .filter = Filter::kBilinear, .culls = true},
        Method{.number = Number::kHalf, .filter = Filter::kBilinear, .samples = 2}}) {
    EXPECT_NE(method_shortfall(method), "") << method_name(method);
    EXPECT_THROW(MethodRenderer(method, scene), Error) << method_name(method);
  }
}

TEST(Method, double_draws_what_the_reference_draws) {
  SceneSpec spec = small_spec();
  const Method method{.number = Number::kDouble, .filter = Filter::kBilinear, .samples = 4};
  const Image drawn = MethodRenderer(method, scene_of(spec)).image();
  spec.view.image.samples = 2;
  EXPECT_EQ(apart(drawn, render(scene_of(spec))), 0);
}

TEST(Method, exact_formulas_draw_one_picture_and_table_1_another) {
  SceneSpec spec = small_spec();
  spec.view.material = *with_formula(spec.view.material, "yiq-eq6");
  const Scene scene = scene_of(spec);
  const auto drawn = [&](Formula formula) {
    const Method method{.space = Space::kYiq, .formula = formula, .filter = Filter::kBilinear};
    return MethodRenderer(method, scene).image();
  };
  const Image matrices = drawn(Formula::kMatrices);
  // M and W are inverse to each other up to 1e-7; colours are floats near 1, baked texels too. (Of
  // mipmaps, levels in r'g'b' are rounded to bytes and baked ones are not.)
  EXPECT_LT(apart(matrices, drawn(Formula::kCollapsed)), 1e-5);
  EXPECT_LT(apart(matrices, drawn(Formula::kBaked)), 1e-5);
  EXPECT_GT(apart(matrices, drawn(Formula::kTable1)), 0.09);  // its offset alone is 0.1
}

TEST(Method, half_is_near_the_reference_but_not_on_it) {
  const Scene scene = scene_of(small_spec());
  const Method method{.number = Number::kHalf, .filter = Filter::kBilinear};
  const double error = apart(MethodRenderer(method, scene).image(), render(scene));
  EXPECT_GT(error, 1e-4);  // a step of half below 1 is 4.9e-4, so some pixel is off by a part of it
  EXPECT_LT(error, 0.3);   // highlights: r.v off by 2^-11, to the power of 55, twice over
}

TEST(Method, words_name_all_that_differs) {
  EXPECT_EQ(method_words({}),
            "the scene's own mesh, light per pixel in RGB, float, trilinear texture, 1 sample per "
            "pixel");
  std::set<std::string> names, words;
  for (const Space space : {Space::kRgb, Space::kYiq}) {
    for (const Formula formula :
         {Formula::kMatrices, Formula::kCollapsed, Formula::kBaked, Formula::kTable1}) {
      for (const int samples : {1, 4}) {
        for (const bool culls : {false, true}) {
          for (const int sides : {0, 12}) {
            const Method method{.segments = 8 * sides,
                                .sides = sides,
                                .space = space,
                                .formula = formula,
                                .samples = samples,
                                .culls = culls};
            names.insert(method_name(method));
            words.insert(method_words(method));
          }
        }
      }
    }
  }
  EXPECT_EQ(words.size(), names.size());
}

TEST(Method, the_grid_replaces_a_knot_s) {
  const MeshSpec mesh = method_mesh({48, 6}, KnotSpec{});
  EXPECT_EQ(std::get<KnotSpec>(mesh).segments, 48);
  EXPECT_EQ(std::get<KnotSpec>(mesh).sides, 6);
  EXPECT_EQ(std::get<KnotSpec>(method_mesh({}, KnotSpec{})).segments, 768);
}

TEST(Method, the_true_material_leaves_out_what_methods_approximate) {
  Material table1 = *with_formula(Material{}, "yiq-table1");
  table1.rate = ShadingFrequency::kVertex;
  const Material material = true_material(table1, Space::kYiq);
  EXPECT_EQ(material.normal, NormalUse::kUnit);
  EXPECT_EQ(material.rate, ShadingFrequency::kPixel);
  EXPECT_EQ(material.luma_offset, -0.1);  // the scene's own look stays
  EXPECT_EQ(true_material(table1, Space::kRgb).luma_offset, 0);
}

}  // namespace
}  // namespace lumaknot::measure
