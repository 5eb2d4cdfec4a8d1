// A texture's mipmap levels.
#include "render/fast/mipmap.h"

#include <gtest/gtest.h>

#include "tests/render/fast/testing.h"

namespace lumaknot::fast {
namespace {

/// A texture of floats, so that levels aren't rounded to bytes.
Mipmap all_levels(int width, int height) {
  return make_mipmap(testing::noise_texture(width, height, 0.3337f), {}, Wrapping::kRepeat, true);
}

double texel(const Mipmap& mipmap, std::size_t level, int x, int y, int channel) {
  const MipLevels& levels = mipmap.levels;
  const int index = levels.firsts[level] + y * levels.strides[level] + x;
  return mipmap.floats[4 * std::size_t(index) + std::size_t(channel)];
}

double mean(const Mipmap& mipmap, std::size_t level, int channel) {
  const int width = mipmap.levels.widths[level], height = mipmap.levels.heights[level];
  double sum = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) sum += texel(mipmap, level, x, y, channel);
  }
  return sum / (width * height);
}

TEST(Mipmap, levels_halve_down_to_one_texel) {
  const MipLevels levels = all_levels(13, 4).levels;
  ASSERT_EQ(levels.count, 4u);
  for (const auto& [level, width, height] :
       {std::tuple{0, 13, 4}, {1, 6, 2}, {2, 3, 1}, {3, 1, 1}}) {
    EXPECT_EQ(levels.widths[std::size_t(level)], width);
    EXPECT_EQ(levels.heights[std::size_t(level)], height);
  }
}

TEST(Mipmap, each_level_has_the_mean_of_the_texture_whatever_its_size) {
  for (const auto& [width, height] :
       {std::pair{3, 3}, {7, 3}, {16, 8}, {1, 5}, {13, 31}, {255, 2}}) {
    const Mipmap mipmap = all_levels(width, height);
    for (std::size_t level = 1; level < mipmap.levels.count; ++level) {
      for (int c = 0; c < 3; ++c) {  // rounded to floats below 1 once per level
        EXPECT_NEAR(mean(mipmap, level, c), mean(mipmap, 0, c), 1e-6) << width << "x" << height;
      }
    }
  }
}

// Two texels instead of five: the middle one is shared by both.
TEST(Mipmap, a_texel_is_the_mean_of_what_it_lies_over) {
  const Mipmap mipmap = all_levels(5, 1);
  for (int c = 0; c < 3; ++c) {
    const auto at = [&](int x) { return texel(mipmap, 0, x, 0, c); };
    EXPECT_NEAR(texel(mipmap, 1, 0, 0, c), (at(0) + at(1) + at(2) / 2) / 2.5, 1e-7);
    EXPECT_NEAR(texel(mipmap, 1, 1, 0, c), (at(2) / 2 + at(3) + at(4)) / 2.5, 1e-7);
  }
}

}  // namespace
}  // namespace lumaknot::fast
