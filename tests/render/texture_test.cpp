#include "render/texture.h"

#include <gtest/gtest.h>

#include "tests/render/testing.h"

namespace lumaknot {
namespace {

/// Values that identify their texel and are not a linear function of it.
TextureImage numbered(int width, int height) {
  TextureImage image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = {float(x * x + 1) / 128, float(y * y + x) / 256, float(x ^ (3 * y)) / 64};
    }
  }
  return image;
}

/// The centre of texel (x, y), rows counted from the top.
Vec2d center(const TextureImage& image, double x, double y) {
  return {(x + 0.5) / image.width, 1 - (y + 0.5) / image.height};
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

// Texture coordinates in [-10, 10] are known to 1e-15; sizes up to 100 and slopes of 1 per texel.
constexpr double kRounding = 1e-12;

TEST(TextureColor, texel_centres_have_their_texels_color) {
  const TextureImage image = numbered(7, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 7; ++x) {
      expect_near(texture_color(image, center(image, x, y)), to_vec(image.at(x, y)), kRounding);
    }
  }
}

TEST(TextureColor, texel_centres_of_power_of_two_images_are_exact) {
  const TextureImage image = numbered(8, 4);  // whose centres are exact in binary
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(texture_color(image, center(image, x, y)), to_vec(image.at(x, y)));
    }
  }
}

TEST(TextureColor, v_grows_upwards_from_the_bottom_row) {
  TextureImage image(1, 2);
  image.at(0, 0) = {1, 0, 0};  // the top row
  image.at(0, 1) = {0, 0, 1};
  EXPECT_EQ(texture_color(image, {0.5, 0.75}), (Vec3d{1, 0, 0}));
  EXPECT_EQ(texture_color(image, {0.5, 0.25}), (Vec3d{0, 0, 1}));
}

TEST(TextureColor, is_bilinear_between_texel_centres) {
  const TextureImage image = numbered(6, 5);
  for (const double s : {0.0, 0.125, 0.5, 0.9}) {
    for (const double t : {0.0, 0.25, 0.75, 0.99}) {
      const Vec3d expected =
          to_vec(image.at(2, 1)) * ((1 - s) * (1 - t)) + to_vec(image.at(3, 1)) * (s * (1 - t)) +
          to_vec(image.at(2, 2)) * ((1 - s) * t) + to_vec(image.at(3, 2)) * (s * t);
      expect_near(texture_color(image, center(image, 2 + s, 1 + t)), expected, kRounding);
    }
  }
}

TEST(TextureColor, blends_across_both_seams) {
  const TextureImage image = numbered(6, 5);
  const Vec3d corners = to_vec(image.at(0, 0)) + to_vec(image.at(5, 0)) + to_vec(image.at(0, 4)) +
                        to_vec(image.at(5, 4));
  for (const Vec2d uv : {Vec2d{0, 0}, Vec2d{1, 0}, Vec2d{0, 1}, Vec2d{1, 1}}) {
    expect_near(texture_color(image, uv), corners / 4.0, kRounding);
  }
  const Vec3d left_right = (to_vec(image.at(0, 2)) + to_vec(image.at(5, 2))) / 2.0;
  expect_near(texture_color(image, {0, center(image, 0, 2).v}), left_right, kRounding);
}

TEST(TextureColor, is_continuous_at_the_seams) {
  const TextureImage image = numbered(6, 5);
  for (const double t : {0.1, 0.37, 0.8}) {
    // The distance of the two points times the slope, at most 6 texels of difference below 1.
    constexpr double kStep = 1e-9, kTolerance = 2e-8;
    expect_near(texture_color(image, {1 - kStep, t}), texture_color(image, {1 + kStep, t}),
                kTolerance);
    expect_near(texture_color(image, {-kStep, t}), texture_color(image, {kStep, t}), kTolerance);
    expect_near(texture_color(image, {t, 1 - kStep}), texture_color(image, {t, 1 + kStep}),
                kTolerance);
    expect_near(texture_color(image, {t, -kStep}), texture_color(image, {t, kStep}), kTolerance);
  }
}

TEST(TextureColor, repeats_in_both_directions) {
  const TextureImage image = numbered(5, 3);
  testing::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Vec2d uv{random.between(0, 1), random.between(0, 1)};
    const Vec3d once = texture_color(image, uv);
    for (const int k : {-9, -1, 1, 7}) {
      expect_near(texture_color(image, {uv.u + k, uv.v}), once, kRounding);
      expect_near(texture_color(image, {uv.u, uv.v + k}), once, kRounding);
    }
  }
}

TEST(TextureColor, stays_between_the_texels_for_any_finite_coordinate) {
  const TextureImage image = numbered(5, 3);  // values of at most 17 / 128 in red
  const double largest = 1.7e308, min = 5e-324;
  for (const double u : {largest, -largest, 1e17, -1e17, min, -min, -1e-17, 1 - 1e-16, -0.0}) {
    for (const double v : {largest, -largest, 1e17, -1e17, min, -min, -1e-17, 1.0, -0.0}) {
      const Vec3d color = texture_color(image, {u, v});
      EXPECT_GE(color.x, 1.0 / 128) << u << " " << v;
      EXPECT_LE(color.x, 17.0 / 128) << u << " " << v;
    }
  }
}

TEST(TextureColor, one_texel_is_one_color_everywhere) {
  TextureImage image(1, 1);
  image.at(0, 0) = {0.25f, 0.5f, 0.75f};
  for (const double u : {-3.3, 0.0, 0.2, 0.5, 0.99, 1.0, 12.0}) {
    EXPECT_EQ(texture_color(image, {u, 1.7 * u}), (Vec3d{0.25, 0.5, 0.75})) << u;
  }
}

TEST(TextureColor, one_row_varies_along_u_alone) {
  const TextureImage image = numbered(4, 1);
  for (const double v : {-0.4, 0.0, 0.3, 1.0}) {
    EXPECT_EQ(texture_color(image, {0.625, v}), to_vec(image.at(2, 0)));
    // Halfway between the texels 2 and 3.
    expect_near(texture_color(image, {0.75, v}),
                (to_vec(image.at(2, 0)) + to_vec(image.at(3, 0))) / 2.0, kRounding);
  }
}

TEST(TextureColor, plain_color_needs_no_coordinates) {
  const Vec3d color{0.1, 0.2, 0.3};
  for (const double u : {-1e300, 0.0, 0.5}) EXPECT_EQ(texture_color(color, {u, -u}), color);
}

}  // namespace
}  // namespace lumaknot
