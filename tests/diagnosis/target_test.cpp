#include "diagnosis/target.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/diagnosis/small_case.h"

namespace lumaknot::diagnosis {
namespace {

using testing::own_picture;
using testing::small_case;

Image rounded(Image image, float steps) {
  for (RgbaPixel& p : image.pixels) {
    for (float* v : {&p.color.r, &p.color.g, &p.color.b}) {
      *v = std::round(std::clamp(*v, 0.0f, 1.0f) * steps) / steps;
    }
  }
  return image;
}

TEST(Facts, tell_the_depth_of_a_picture_from_its_values) {
  const Image own = own_picture(small_case());
  EXPECT_EQ(facts_of(own, false).depth, Depth::kFloat);
  EXPECT_EQ(facts_of(rounded(own, 255), false).depth, Depth::kEightBits);
  EXPECT_EQ(facts_of(rounded(own, 65535), false).depth, Depth::kSixteenBits);
}

TEST(Facts, of_integers_say_that_they_are_limited) {
  const Image own = own_picture(small_case());
  EXPECT_FALSE(facts_of(own, false).limited);
  EXPECT_TRUE(facts_of(rounded(own, 255), false).limited);
}

TEST(Facts, know_the_background_of_a_picture_without_alpha) {
  Image image = own_picture(small_case());
  for (RgbaPixel& p : image.pixels) {
    if (p.coverage == 0) p.color = {0.2f, 0.3f, 0.4f};
    p.coverage = 1;
  }
  const Target target = target_of(image, false, 1 << 20);
  EXPECT_FALSE(target.facts.has_alpha);
  EXPECT_FLOAT_EQ(float(target.facts.background.y), 0.3f);
  const Image own = own_picture(small_case());
  for (std::size_t i = 0; i < own.pixels.size(); ++i) {
    EXPECT_EQ(target.coverage[i], own.pixels[i].coverage);
  }
}

}  // namespace
}  // namespace lumaknot::diagnosis
