#include "shaders/spaces/atd95.h"

#include <gtest/gtest.h>

#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

/// Final responses A1, T1, D1.
Vec3d final_responses(const Vec3d& xyz, const Atd95Model& model) {
  const Atd95<double> r = atd95_from_xyz<double>(xyz, model);
  return {final_response(r.a + model.black.a), final_response(r.t + model.black.t),
          final_response(r.d + model.black.d)};
}

/// A worked example, XYZ with Y of white 1.
struct Example {
  Vec3d xyz, white;
  double white_luminance;
  Vec3d printed, computed;
};

/// Fairchild's four worked examples, k1 = 0, k2 = 50, sigma = 300: "Color Appearance Models" and
/// its spreadsheet AppModEx.xls, four decimals, as the tests of colour-science 0.4.7 quote them.
/// Beside them the digits that colour-science computes.
const Example kExamples[] = {{{0.1901, 0.2000, 0.2178},
                              {0.9505, 1, 1.0888},
                              318.31,
                              {0.1788, 0.0287, 0.0108},
                              {0.178793144152, 0.0286942732668, 0.0107584518764}},
                             {{0.5706, 0.4306, 0.3196},
                              {0.9505, 1, 1.0888},
                              31.83,
                              {0.2031, 0.0680, 0.0005},
                              {0.203125990238, 0.0679770854226, 0.000480759131717}},
                             {{0.0353, 0.0656, 0.0214},
                              {1.0985, 1, 0.3558},
                              318.31,
                              {0.1068, -0.0110, 0.0044},
                              {0.106814423057, -0.0109534959512, 0.00444052373874}},
                             {{0.1901, 0.2000, 0.2178},
                              {1.0985, 1, 0.3558},
                              31.83,
                              {0.1460, 0.0007, 0.0130},
                              {0.146017298107, 0.000735350671764, 0.0129960388624}}};

TEST(Atd95, has_the_responses_of_fairchild_s_worked_examples) {
  for (const Example& e : kExamples) {
    const Atd95Model model = atd95_model({.white = e.white, .white_luminance = e.white_luminance});
    const Vec3d found = final_responses(e.xyz, model);
    EXPECT_LT(largest_magnitude(found - e.printed), 5e-5);      // half a last decimal
    EXPECT_LT(largest_magnitude(found - e.computed), 5.1e-13);  // twelve digits
  }
}

TEST(Atd95, comes_back_from_the_responses) {
  for (const Example& e : kExamples) {
    const Atd95Model model = atd95_model({.white = e.white, .white_luminance = e.white_luminance});
    const Vec3d back = xyz_from_atd95(atd95_from_xyz<double>(e.xyz, model), model);
    EXPECT_LT(largest_magnitude(back - e.xyz), 1e-14);
  }
}

TEST(Atd95, shading_space_has_the_responses_of_the_colour_library) {
  // colour-science 0.4.7 with its white set to ours, nine digits.
  const std::pair<Vec3d, Vec3d> samples[] = {
      {{1, 0, 0}, {0.176049117, 0.124289207, -0.0161075354}},
      {{0, 1, 0}, {0.309380726, 0.0129662365, -0.0150407074}},
      {{0, 0, 1}, {0.110756213, -0.00301482992, 0.0561040181}},
      {{0.8, 0.5, 0.2}, {0.206871732, 0.0749886231, -0.00932810159}},
      {{0.02, 0.01, 0.03}, {0.0114374411, 0.00200094745, 0.00160514106}},
      {{1, 1, 1}, {0.348979201, 0.0678406906, 0.0256824983}}};
  for (const auto& [rgb, expected] : samples) {
    const Vec3d found = final_responses(xyz_from_rgb<double>(rgb), atd95_shading_model());
    EXPECT_LT(largest_magnitude(found - expected), 5.1e-10);
  }
}

TEST(Atd95, brightness_is_the_final_response_between_black_s_and_white_s) {
  const Atd95Model& model = atd95_shading_model();
  const double black = final_responses({0, 0, 0}, model).x;
  const double white = final_responses(kWhiteXyz, model).x;
  for (const Vec3d& color : color_cube(5)) {
    const double response = final_responses(xyz_from_rgb<double>(color), model).x;
    EXPECT_NEAR(brightness_of<double>(color, Space::kAtd95), (response - black) / (white - black),
                1e-14);
  }
}

TEST(Atd95, brighter_than_white_goes_on_along_the_tangent) {
  const Atd95Model& model = atd95_shading_model();
  const double step = 1e-5;
  const double white = atd95_of_brightness(1.0, model);
  const double below = white - atd95_of_brightness(1 - step, model);
  const double above = atd95_of_brightness(1 + step, model) - white;
  EXPECT_NEAR(below / above, 1, 1e-5);  // curvature 2 A / (1 - A) = 1.1, times the step
  EXPECT_NEAR(white, model.white.a, 1e-12);
  const double slope = 200 / std::pow(1 - model.white_response, 2);  // dA_i / dA
  const double span = model.white_response - model.black_response;
  EXPECT_NEAR(atd95_of_brightness(50.0, model), white + 49 * span * slope, 1e-9);
}

TEST(Atd95, greys_lie_on_a_line_through_black) {
  // That is why chroma can be measured from the grey of the same A.
  const Atd95Model& model = atd95_shading_model();
  for (const double shade : {0.05, 0.3, 0.8}) {
    const Atd95<double> r = atd95_from_xyz<double>(xyz_from_rgb<double>(grey(shade)), model);
    EXPECT_NEAR(r.t / r.a, model.white.t / model.white.a, 1e-13);
    EXPECT_NEAR(r.d / r.a, model.white.d / model.white.a, 1e-13);
  }
}

TEST(Atd95, t_and_d_as_guth_has_them_would_tint_a_lit_grey) {
  const Atd95Model& model = atd95_shading_model();
  Atd95<double> r = atd95_from_xyz<double>(xyz_from_rgb<double>(grey(0.5)), model);
  EXPECT_NEAR(brightness_of_atd95(r.a, model), 0.528, 5e-4);
  r.a = atd95_of_brightness(0.9, model);
  const Vec3d tinted = rgb_from_xyz<double>(xyz_from_atd95(r, model));
  const Vec3d documented{0.590, 0.958, 0.705};  // a clear green; three decimals
  EXPECT_LT(largest_magnitude(tinted - documented), 5e-4);
  const Vec3d lit = rgb_from_axes(Axes<double>{0.9, 0, 0}, Space::kAtd95);
  EXPECT_LT(largest_magnitude(lit - grey(lit.x)), 1e-14);
}

}  // namespace
}  // namespace lumaknot
