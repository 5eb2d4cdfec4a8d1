#include "validate/compare/claims.h"

#include <gtest/gtest.h>

namespace lumaknot::validate {
namespace {

Image filled(Rgb color) {
  Image image(4, 4);
  for (RgbaPixel& p : image.pixels) p = {color, 1};
  return image;
}

TEST(Claims, a_grey_highlight_has_no_chroma_and_a_red_one_has) {
  const Image texture = filled({0.6f, 0.2f, 0.1f}), specular = filled({0.5f, 0.5f, 0.5f});
  EXPECT_EQ(measure_claims(filled({0.5f, 0.5f, 0.5f}), texture, specular).highlight_chroma, 0);
  const Claims red = measure_claims(filled({0.9f, 0.5f, 0.4f}), texture, specular);
  EXPECT_EQ(red.highlight_pixels, 16);
  EXPECT_NEAR(red.highlight_chroma, 0.5, 1e-6);  // float32
}

TEST(Claims, pixels_without_highlight_or_coverage_do_not_count) {
  Image final = filled({1, 0, 0});
  Image specular = filled({0.05f, 0.05f, 0.05f});
  final.pixels[0].coverage = 0;
  const Claims claims = measure_claims(final, filled({1, 0, 0}), specular);
  EXPECT_EQ(claims.highlight_pixels, 0);
  EXPECT_EQ(claims.highlight_chroma, 0);
}

TEST(Claims, scaling_a_color_keeps_its_hue_and_swapping_channels_turns_it) {
  const Image texture = filled({0.8f, 0.4f, 0.2f}), specular = filled({});
  EXPECT_NEAR(measure_claims(filled({0.4f, 0.2f, 0.1f}), texture, specular).hue_shift_degrees, 0,
              1e-4);  // float32 colours
  EXPECT_GT(measure_claims(filled({0.2f, 0.4f, 0.8f}), texture, specular).hue_shift_degrees, 90);
}

TEST(Claims, shares_of_clipped_pixels_are_counted_at_both_ends) {
  Image final = filled({0.5f, 0.5f, 0.5f});
  final.pixels[0].color = {-0.1f, 0.5f, 0.5f};
  final.pixels[1].color = {0.5f, 1.2f, 0.5f};
  final.pixels[2].color = {0, 0.5f, 1};
  const Claims claims = measure_claims(final, final, filled({}));
  EXPECT_DOUBLE_EQ(claims.clipped_at_zero, 2.0 / 16);
  EXPECT_DOUBLE_EQ(claims.clipped_at_one, 2.0 / 16);
}

}  // namespace
}  // namespace lumaknot::validate
