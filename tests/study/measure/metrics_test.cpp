#include "study/measure/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lumaknot::measure {
namespace {

Image plain(float r, float g, float b, float coverage = 1) {
  Image image(40, 30);
  for (RgbaPixel& p : image.pixels) p = {{r, g, b}, coverage};
  return image;
}

TEST(Metrics, equal_images_have_no_error) {
  const SeenImage image = seen(plain(0.2f, 0.5f, 0.7f));
  const Errors e = errors_between(image, image);
  for (const double x : {e.rmse, e.max, e.p999, e.delta_e, e.delta_e_max, e.delta_e_p999, e.flip}) {
    EXPECT_EQ(x, 0);
  }
}

TEST(Metrics, images_without_a_covered_pixel_have_no_error) {
  const SeenImage nothing = seen(plain(0, 0, 0, 0));
  EXPECT_EQ(errors_between(nothing, nothing).rmse, 0);
}

TEST(Metrics, errors_of_one_colour_are_those_of_each_pixel) {
  const Errors e = errors_between(seen(plain(0.5f, 0.5f, 0.5f)), seen(plain(0.5f, 0.75f, 0.5f)));
  EXPECT_NEAR(e.rmse, 0.25 / std::sqrt(3), 1e-9);  // values are exact in float
  EXPECT_EQ(e.max, 0.25);
  EXPECT_EQ(e.p999, 0.25);
  EXPECT_NEAR(e.delta_e, e.delta_e_max, 1e-12);
  EXPECT_GT(e.delta_e, 10);
}

TEST(Metrics, the_background_does_not_dilute_them_but_flip) {
  Image truth = plain(0, 0, 0, 0), image = truth;
  truth.at(3, 4) = {{0.5f, 0.5f, 0.5f}, 1};
  image.at(3, 4) = {{0.75f, 0.75f, 0.75f}, 1};
  image.at(5, 5) = {{0, 0, 0}, 1};  // covered in one alone, and as black as the background
  const Errors e = errors_between(seen(truth), seen(image));
  EXPECT_NEAR(e.rmse, 0.25 / std::sqrt(2), 1e-9);
  EXPECT_NEAR(e.delta_e * 2, e.delta_e_max, 1e-12);
  EXPECT_LT(e.flip, 0.01);
}

TEST(Metrics, p999_leaves_one_pixel_in_a_thousand_out) {
  Image truth = plain(0, 0, 0), image = truth;  // 1200 pixels: one may be left out
  image.at(0, 0).color = {1, 1, 1};
  EXPECT_EQ(errors_between(seen(truth), seen(image)).p999, 0);
  image.at(1, 0).color = {0.5f, 0, 0};
  EXPECT_EQ(errors_between(seen(truth), seen(image)).p999, 0.5);
}

TEST(Metrics, colours_that_no_display_shows_are_limited_first) {
  const Errors e = errors_between(seen(plain(1, 0, 0.5f)), seen(plain(1.7f, -0.3f, 0.5f)));
  EXPECT_EQ(e.rmse, 0);
  EXPECT_EQ(e.flip, 0);
}

}  // namespace
}  // namespace lumaknot::measure
