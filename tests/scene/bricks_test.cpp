#include "scene/bricks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lumaknot {
namespace {

double difference(const Rgb& a, const Rgb& b) {
  return (std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b)) / 3.0;
}

/// The mean difference of each column to the one on its right; the last one's is the first.
std::vector<double> column_steps(const TextureImage& image) {
  std::vector<double> steps;
  for (int x = 0; x < image.width; ++x) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y) {
      sum += difference(image.at(x, y), image.at((x + 1) % image.width, y));
    }
    steps.push_back(sum / image.height);
  }
  return steps;
}

TextureImage transposed(const TextureImage& image) {
  TextureImage result(image.height, image.width);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) result.at(y, x) = image.at(x, y);
  }
  return result;
}

/// The seam is at a multiple of `period` steps, in the middle of joints: it must be of their size.
/// Means over 512 texels of grain vary by a tenth; a lattice that does not repeat doubles it.
void expect_no_seam(const std::vector<double>& steps, std::size_t period) {
  double largest = 0;
  for (std::size_t i = period; i < steps.size(); i += period) {
    largest = std::max(largest, steps[i - 1]);
  }
  EXPECT_LE(steps.back(), 1.2 * largest);
  EXPECT_GT(steps.back(), 0);
}

TEST(Bricks, are_512_by_512) {
  const TextureImage image = bricks();
  EXPECT_EQ(image.width, 512);
  EXPECT_EQ(image.height, 512);
  EXPECT_EQ(image.pixels.size(), 512u * 512u);
}

TEST(Bricks, an_8_bit_file_holds_every_value_exactly) {
  for (const Rgb& c : bricks().pixels) {
    for (const float value : {c.r, c.g, c.b}) {
      const float level = std::round(value * 255.0f);
      ASSERT_EQ(value, level / 255.0f);
      ASSERT_GE(level, 0.0f);
      ASSERT_LE(level, 255.0f);
    }
  }
}

TEST(Bricks, tile_at_the_left_and_right_edge) { expect_no_seam(column_steps(bricks()), 128); }

TEST(Bricks, tile_at_the_top_and_bottom_edge) {
  expect_no_seam(column_steps(transposed(bricks())), 64);
}

TEST(Bricks, are_the_same_bytes_each_time) { EXPECT_EQ(bricks().pixels, bricks().pixels); }

TEST(Bricks, show_red_clay_and_grey_mortar) {
  int clay = 0, mortar = 0;
  const TextureImage image = bricks();
  for (const Rgb& c : image.pixels) {
    if (c.r > 1.6f * c.g && c.g > c.b) ++clay;
    if (std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}) < 0.15f && c.r > 0.5f) ++mortar;
  }
  // A wall: mostly bricks, the joints a good tenth of it.
  EXPECT_GT(clay, int(image.pixels.size()) / 2);
  EXPECT_GT(mortar, int(image.pixels.size()) / 20);
}

TEST(Bricks, have_chroma_for_yiq_to_keep) {
  // A texture without hue would draw the same in both of the paper's models.
  double sum = 0;
  const TextureImage image = bricks();
  for (const Rgb& c : image.pixels) sum += double(c.r) - double(c.b);
  EXPECT_GT(sum / double(image.pixels.size()), 0.2);
}

}  // namespace
}  // namespace lumaknot
