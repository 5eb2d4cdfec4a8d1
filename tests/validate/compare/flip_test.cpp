#include "validate/compare/flip.h"

#include <gtest/gtest.h>

namespace lumaknot::validate {
namespace {

Image plain(float r, float g, float b) {
  Image image(40, 30);
  for (RgbaPixel& p : image.pixels) p = {{r, g, b}, 1};
  return image;
}

TEST(Flip, black_and_white_are_as_far_apart_as_can_be) {
  // 0.97 in the paper's text for black against white; colours only, since plains have no features.
  const double flip = mean_flip(flip_image(plain(0, 0, 0)), flip_image(plain(1, 1, 1)));
  EXPECT_GT(flip, 0.95);
  EXPECT_LE(flip, 1);
}

TEST(Flip, a_translation_of_noise_too_fine_for_the_eye_is_less_than_one_of_blocks) {
  const auto checkers = [](int side, int shift) {
    Image image(64, 64);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const float c = ((x + shift) / side + y / side) % 2 == 0 ? 0.75f : 0.25f;
        image.at(x, y) = {{c, c, c}, 1};
      }
    }
    return flip_image(image);
  };
  EXPECT_LT(mean_flip(checkers(1, 0), checkers(1, 1)),
            mean_flip(checkers(8, 0), checkers(8, 8)) / 3);
}

TEST(Flip, near_differences_is_what_it_is_in_the_whole_image) {
  Image ours(300, 200);
  for (int y = 0; y < ours.height; ++y) {
    for (int x = 0; x < ours.width; ++x) {
      const float c = float((x * 7 + y * 13) % 32) / 31;
      ours.at(x, y) = {{c, 1 - c, 0.5f}, 1};
    }
  }
  Image theirs = ours;
  theirs.at(127, 60).color = {};  // beside a tile's border
  theirs.at(299, 199).color = {};
  const Grid<float> whole = flip_errors(flip_image(ours), flip_image(theirs));
  const Grid<float> near = flip_errors_near(ours, theirs, 0.01f);
  for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
    ASSERT_EQ(near.pixels[i], whole.pixels[i]) << i % 300 << ", " << i / 300;
  }
}

}  // namespace
}  // namespace lumaknot::validate
