#include "scene/presets.h"
#include "study/paper/instruction_slots.h"
#include "study/paper/listing_claims.h"
#include "tests/study/paper/testing.h"

namespace lumaknot::paper {
namespace {

const Image kPlain = filled({0.5f, 0.4f, 0.3f}), kDarker = filled({0.4f, 0.3f, 0.2f});

TEST(PaperListing, a_listing_that_draws_the_equations_picture_holds) {
  const ListingPictures same{kPlain, kPlain, kPlain, kPlain, kPlain};
  const ListingPictures other{kPlain, kDarker, kDarker, kDarker, kDarker};
  for (auto* claim : {listing_claim, offset_claim, clamps_claim, normal_claim}) {
    EXPECT_EQ(ruling_of(claim(same)), Ruling::kHolds) << claim(same).name;
    EXPECT_EQ(ruling_of(claim(other)), Ruling::kDoesNotHold) << claim(other).name;
    EXPECT_NEAR(measure(claim(other), "largest change").value, 0.1, 1e-6);  // float colours
  }
}

TEST(PaperListing, what_a_display_does_not_show_is_no_change) {
  const ListingPictures same{kPlain, with_first(kPlain, {0.5f, 0.4f, 0.303f}), {}, {}, {}};
  EXPECT_EQ(ruling_of(listing_claim(same)), Ruling::kHolds);  // less than 1/255
}

TEST(PaperListing, highlights_on_dark_sides_are_reported_per_picture) {
  EXPECT_EQ(ruling_of(gate_claim({{"front", 0}, {"back", 0}})), Ruling::kHolds);
  EXPECT_EQ(ruling_of(gate_claim({{"front", 0}, {"back", 3}})), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(gate_claim({{"back", 3}})), Ruling::kDoesNotHold);
}

TEST(PaperListing, a_default_within_its_slider_holds) {
  EXPECT_EQ(ruling_of(slider_claim({16, 55, kPlain, kDarker})), Ruling::kDoesNotHold);
  EXPECT_EQ(ruling_of(slider_claim({16, 10, kPlain, kPlain})), Ruling::kHolds);
}

TEST(PaperListing, approximately_forty_slots_are_within_a_tenth) {
  EXPECT_EQ(ruling_of(slots_claim(40, 4)), Ruling::kHolds);
  EXPECT_EQ(ruling_of(slots_claim(31, 15)), Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(slots_claim(100, 15)), Ruling::kDoesNotHold);
}

TEST(PaperListing, words_of_hlsl_that_glsl_lacks_are_counted) {
  const PaperClaim few = glsl_claim("float3 f(float3 a) { return saturate(a * 2.0); }",
                                    "vec3 f(vec3 a) { return clamp(a * 2.0, 0.0, 1.0); }");
  EXPECT_EQ(ruling_of(few), Ruling::kHolds);
  EXPECT_EQ(measure(few, "words to replace").value, 2);
  EXPECT_EQ(ruling_of(glsl_claim("a b c d e f", "u v w x y z")), Ruling::kDoesNotHold);
}

TEST(PaperListing, a_text_that_declares_twice_or_leaves_brackets_open_is_not_ready) {
  EXPECT_EQ(ruling_of(ready_claim("float3 f() { float a = 1; } float3 g() { float a = 2; }")),
            Ruling::kHolds);
  EXPECT_EQ(ruling_of(ready_claim("void f() { float3 a = 1;\nfloat3 a = 1; }")),
            Ruling::kHoldsInPart);
  EXPECT_EQ(ruling_of(ready_claim("t { void f() { float a = 1; float a = 1; }")),
            Ruling::kHoldsInPart);  // what is left open has no end to look at
}

int slots_of(std::string_view formula) {
  const View view = builtin_scene("figure2")->view;
  const Shot shot{"final", Stage::kFinal, *with_formula(view.material, formula)};
  return pixel_slots(make_shader({"job", view, shot, Keep::kNeeded, {}}));
}

Shader shader_of(const NodePtr& color) {
  Shader shader;
  shader.recorded.color = color;
  return shader;
}

constexpr int kOutput = 2;  // alpha and the output

TEST(PaperSlots, a_product_and_its_sum_are_one_instruction) {
  const Scalar a = scalar_input("a"), b = scalar_input("b"), c = scalar_input("c");
  EXPECT_EQ(pixel_slots(shader_of((a * b + c).node)), kOutput + 1);
  const Scalar product = a * b;
  EXPECT_EQ(pixel_slots(shader_of(((product + c) * product).node)), kOutput + 3);  // read twice
}

TEST(PaperSlots, saturating_is_free_unless_the_value_itself_is_read) {
  const Scalar a = scalar_input("a"), b = scalar_input("b");
  const Scalar sum = a + b;
  EXPECT_EQ(pixel_slots(shader_of(saturate(sum).node)), kOutput + 1);
  EXPECT_EQ(pixel_slots(shader_of((saturate(sum) * sum).node)), kOutput + 3);
  EXPECT_EQ(pixel_slots(shader_of(saturate(a).node)), kOutput + 1);  // a move
}

TEST(PaperSlots, macros_take_the_slots_that_the_model_gives_them) {
  const ScalarVec v = vector_input("v");
  EXPECT_EQ(pixel_slots(shader_of(unit(v).node)), kOutput + 3);
  EXPECT_EQ(pixel_slots(shader_of(dot(v, v).node)), kOutput + 1);
  EXPECT_EQ(pixel_slots(shader_of(grey(x_of(v)).node)), kOutput);
}

TEST(PaperSlots, forms_of_yiq_differ_by_their_conversions) {
  EXPECT_LT(slots_of("rgb-phong"), slots_of("yiq-baked-phong"));
  EXPECT_LT(slots_of("yiq-baked-phong"), slots_of("yiq-phong"));
  EXPECT_LT(slots_of("yiq-collapsed-phong"), slots_of("yiq-phong"));
}

}  // namespace
}  // namespace lumaknot::paper
