#include <gtest/gtest.h>

#include "tests/shaders/graph/rounding_bound.h"
#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

using namespace rounding;

struct Light {
  double light, highlight;
};

/// Light from dark to dazzling, with and without highlights and an offset; all of them floats.
constexpr Light kLights[] = {{0, 0},     {0.125, 0}, {0.5, 0},       {0.875, 0},
                             {1, 0},     {1.5, 0},   {3, 0.375},     {0.25, 0.25},
                             {0, 0.625}, {8, 0},     {0.75, -0.125}, {0.125, -0.125}};

/// The formula: colour in, lit colour out, not limited.
NodePtr recorded(Space space) {
  Axes<Scalar> axes = axes_from_rgb<Scalar>(vector_input("texture"), space);
  axes.brightness = axes.brightness * scalar_input("light") + scalar_input("highlight");
  return rgb_from_axes(axes, space).node;
}

Inputs inputs(const Vec3d& color, const Light& l) {
  return {{"texture", color}, {"light", {l.light, 0, 0}}, {"highlight", {l.highlight, 0, 0}}};
}

/// Calls `f` with many colours, all of them floats and many near the sides of the cube, under every
/// light.
template <class F>
void for_each_lit_color(F f) {
  constexpr double kSteps[] = {0, 1 / 64.0, 1 / 32.0, 0.375, 0.8125, 15 / 16.0, 1};
  for (const double r : kSteps)
    for (const double g : kSteps)
      for (const double b : kSteps)
        for (const Light& l : kLights) f(Vec3d{r, g, b}, l);
}

/// The visible error of a channel: none where it is limited to 0 or 1 anyway.
Vec3d visible(const Vec3d& error, const Vec3d& value) {
  return by_component(error, value, [](double e, double v) { return v < 0 || v > 1 ? 0 : e; });
}

/// The largest error of a lit colour in float, of full scale.
struct Errors {
  double measured = 0;       ///< float against double
  double library_bound = 0;  ///< derived: C libraries accurate to the last place stay within it
  double vulkan_bound = 0;   ///< derived: GPUs that meet Vulkan's rules stay within it
};

Errors errors_of(Space space) {
  const Tape tape = tape_of(recorded(space));
  Errors result;
  for_each_lit_color([&](const Vec3d& color, const Light& l) {
    const std::vector<Vec3d> values = values_of(tape, inputs(color, l));
    const Vec3d exact = values.back();
    const Vec3d single =
        widened(with_light(narrowed<float>(color), float(l.light), float(l.highlight), space));
    const Vec3d library = rounding_bound<LibraryErrors>(tape, values);
    const Vec3d vulkan = rounding_bound<VulkanErrors>(tape, values);
    const Vec3d error = visible(absolute(single - exact), exact);
    const Vec3d over = error - library;
    // 1e-7: second order, and the sRGB curve's pieces that meet within 3e-8.
    EXPECT_LT(largest_component(over), 1e-7)
        << name_of(space) << " " << color.x << " " << color.y << " " << color.z << " " << l.light;
    result.measured = std::max(result.measured, largest_magnitude(error));
    result.library_bound =
        std::max(result.library_bound, largest_magnitude(visible(library, exact)));
    result.vulkan_bound = std::max(result.vulkan_bound, largest_magnitude(visible(vulkan, exact)));
  });
  return result;
}

/// The figures of docs/spaces, rounded up.
const std::map<Space, Errors> kDocumented{
    {Space::kYiq, {4e-7, 1.2e-6, 1.2e-6}},  {Space::kYuv601, {4e-7, 7e-7, 7e-7}},
    {Space::kYuv709, {4e-7, 6e-7, 6e-7}},   {Space::kCielab, {1e-5, 6e-5, 1.2e-4}},
    {Space::kCieluv, {1.2e-5, 5e-5, 7e-5}}, {Space::kDin99, {1.2e-5, 9e-5, 1.8e-4}},
    {Space::kAtd95, {2.6e-5, 2.2e-4, 5e-4}}};

TEST(SpaceError, of_lit_colours_in_float_is_the_documented_one_and_within_the_derived_bound) {
  for (const Space space : kLumaSpaces) {
    const Errors found = errors_of(space);
    const Errors& documented = kDocumented.at(space);
    RecordProperty(name_of(space) + "_e9", int(found.measured * 1e9));
    RecordProperty(name_of(space) + "_library_e9", int(found.library_bound * 1e9));
    RecordProperty(name_of(space) + "_vulkan_e9", int(found.vulkan_bound * 1e9));
    EXPECT_LT(found.measured, documented.measured) << name_of(space);
    EXPECT_LT(found.library_bound, documented.library_bound) << name_of(space);
    EXPECT_LT(found.vulkan_bound, documented.vulkan_bound) << name_of(space);
  }
}

TEST(RecordedSpace, computes_what_the_template_computes) {
  for (const Space space : kLumaSpaces) {
    const Tape tape = tape_of(recorded(space));
    for (const Vec3d& color : color_cube(5)) {
      const Vec3d found = values_of(tape, inputs(color, {0.75, 0.125})).back();
      // The recorder omits products with 1 and sums with 0, nothing else.
      ASSERT_LT(largest_magnitude(found - with_light(color, 0.75, 0.125, space)), 1e-14)
          << name_of(space);
    }
  }
}

TEST(RecordedSpace, brightness_of_a_linear_space_is_one_dot_product) {
  for (const Space space : kLumaSpaces) {
    const Scalar brightness = brightness_of<Scalar>(vector_input("texture"), space);
    EXPECT_EQ(brightness.node->op == Op::kDot && in_order({brightness.node}).size() == 3,
              is_linear(space))
        << name_of(space);
  }
}

TEST(RecordedSpace, out_of_gamut_rule_is_recorded_as_it_computes) {
  const Tape tape =
      tape_of(reduce_chroma<Scalar>(vector_input("texture"), scalar_input("grey")).node);
  for (const Vec3d& color : color_cube(5)) {
    const Vec3d wide = color * 3.0 - grey(1.0);
    const Vec3d found = values_of(tape, {{"texture", wide}, {"grey", {0.4, 0, 0}}}).back();
    ASSERT_LT(largest_magnitude(found - reduce_chroma(wide, 0.4)), 1e-15);
  }
}

TEST(RoundingBound, of_a_product_is_its_rounding_and_that_of_its_constants) {
  const Scalar x = scalar_input("x");
  const Tape tape = tape_of((x * Scalar(0.5) * Scalar(0.1)).node);
  const std::vector<Vec3d> values = values_of(tape, {{"x", {3, 0, 0}}});
  const double constant = 1.5 * std::abs(0.1 - double(0.1f));
  const double expected = kFloatRounding * (1.5 * 0.1 + 0.15) + constant;
  EXPECT_NEAR(rounding_bound<LibraryErrors>(tape, values, {1, 0, 0}), expected, 1e-20);
}

TEST(RoundingBound, sees_cancellation) {
  const Scalar x = scalar_input("x");
  const Scalar y = x * Scalar(0.75);
  const Tape tape = tape_of(((y + Scalar(1000)) - y).node);  // y cancels, its rounding too
  const std::vector<Vec3d> values = values_of(tape, {{"x", {1, 0, 0}}});
  EXPECT_NEAR(rounding_bound<LibraryErrors>(tape, values, {1, 0, 0}),
              kFloatRounding * (1000.75 + 1000), 1e-18);
}

}  // namespace
}  // namespace lumaknot
