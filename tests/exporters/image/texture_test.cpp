// Textures: read and written unchanged.
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exporters/image/file.h"
#include "scene/bricks.h"
#include "tests/exporters/testing.h"

namespace lumaknot {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;

/// Writes `values`, width * height * channels of them, as another program would: no gamma,
/// unassociated alpha.
template <class T>
std::filesystem::path written(const TemporaryFolder& folder, const std::string& name, int width,
                              int height, int channels, const std::vector<T>& values) {
  const std::string path = (folder / name).string();
  OIIO::ImageSpec spec(width, height, channels, OIIO::BaseTypeFromC<T>::value);
  spec["oiio:UnassociatedAlpha"] = 1;
  auto output = OIIO::ImageOutput::create(path);
  EXPECT_TRUE(output && output->open(path, spec) &&
              output->write_image(spec.format, values.data()) && output->close());
  return path;
}

template <class Integer>
Rgb fractions(Integer r, Integer g, Integer b) {
  constexpr float kMax = float(std::numeric_limits<Integer>::max());
  return {float(r) / kMax, float(g) / kMax, float(b) / kMax};
}

int bit_depth(const std::string& png) {
  return png[24];
}  // in the IHDR chunk, as defined by the standard

TEST(TexturePng, eight_bit_texture_is_read_back_exactly) {
  const TemporaryFolder folder;
  TextureImage image(256, 3);  // every value in every channel
  for (int x = 0; x < 256; ++x) {
    const auto v = std::uint8_t(x);
    image.at(x, 0) = fractions<std::uint8_t>(v, 0, 255);
    image.at(x, 1) = fractions<std::uint8_t>(7, v, 9);
    image.at(x, 2) = fractions<std::uint8_t>(std::uint8_t(255 - x), 1, v);
  }
  const std::string png = texture_png(image);
  EXPECT_EQ(bit_depth(png), 8);
  const TextureImage read = read_texture(folder.file("t.png", png), "texture.file");
  EXPECT_EQ(read.width, 256);
  EXPECT_EQ(read.height, 3);
  EXPECT_EQ(read.pixels, image.pixels);
}

TEST(TexturePng, sixteen_bit_texture_is_read_back_exactly) {
  const TemporaryFolder folder;
  TextureImage image(256, 256);  // every value of 16 bits
  for (int i = 0; i < 65536; ++i) {
    image.pixels[std::size_t(i)] = fractions<std::uint16_t>(
        std::uint16_t(i), std::uint16_t(65535 - i), std::uint16_t(i * 40503));
  }
  const std::string png = texture_png(image);
  EXPECT_EQ(bit_depth(png), 16);
  EXPECT_EQ(read_texture(folder.file("t.png", png), "texture.file").pixels, image.pixels);
}

TEST(TexturePng, bricks_fit_eight_bits) {
  const TemporaryFolder folder;
  const std::string png = texture_png(bricks());
  EXPECT_EQ(bit_depth(png), 8);
  EXPECT_EQ(read_texture(folder.file("t.png", png), "texture.file").pixels, bricks().pixels);
}

TEST(TexturePng, gives_the_same_bytes_twice) {
  EXPECT_EQ(texture_png(testing::small_texture()), texture_png(testing::small_texture()));
}

TEST(GreyPng, keeps_sixteen_bits_and_reads_as_grey) {
  const TemporaryFolder folder;
  Grid<float> values(3, 1);
  values.pixels = {0.0f, 12345.0f / 65535.0f, 1.0f};
  const std::string png = grey_png(values);
  EXPECT_EQ(bit_depth(png), 16);
  const TextureImage read = read_texture(folder.file("t.png", png), "texture.file");
  for (std::size_t i = 0; i < 3; ++i) {
    const float v = values.pixels[i];
    EXPECT_EQ(read.pixels[i], (Rgb{v, v, v}));
  }
}

TEST(GreyPng, limits_values_to_the_unit_interval) {
  const TemporaryFolder folder;
  Grid<float> values(2, 1);
  values.pixels = {-0.5f, 1.5f};
  const TextureImage read = read_texture(folder.file("t.png", grey_png(values)), "texture.file");
  EXPECT_EQ(read.pixels[0], Rgb{});
  EXPECT_EQ(read.pixels[1], (Rgb{1, 1, 1}));
}

TEST(ReadTexture, first_row_is_the_top_row) {
  const TemporaryFolder folder;
  const auto path = written<std::uint8_t>(folder, "t.png", 1, 2, 3, {255, 0, 0, 0, 0, 255});
  const TextureImage read = read_texture(path, "texture.file");
  EXPECT_EQ(read.at(0, 0), (Rgb{1, 0, 0}));
  EXPECT_EQ(read.at(0, 1), (Rgb{0, 0, 1}));
}

TEST(ReadTexture, grey_becomes_equal_channels) {
  const TemporaryFolder folder;
  const auto path = written<std::uint8_t>(folder, "t.png", 2, 1, 1, {51, 204});
  const TextureImage read = read_texture(path, "texture.file");
  EXPECT_EQ(read.pixels[0], fractions<std::uint8_t>(51, 51, 51));
  EXPECT_EQ(read.pixels[1], fractions<std::uint8_t>(204, 204, 204));
}

TEST(ReadTexture, alpha_of_a_grey_image_is_left_out_and_not_multiplied_in) {
  const TemporaryFolder folder;
  const auto path = written<std::uint8_t>(folder, "t.png", 3, 1, 2, {51, 255, 51, 100, 51, 0});
  for (const Rgb& p : read_texture(path, "texture.file").pixels) {
    EXPECT_EQ(p, fractions<std::uint8_t>(51, 51, 51));
  }
}

TEST(ReadTexture, alpha_of_a_color_image_is_left_out_and_not_multiplied_in) {
  const TemporaryFolder folder;
  const auto path = written<std::uint8_t>(folder, "t.png", 3, 1, 4,
                                          {10, 20, 30, 255, 10, 20, 30, 100, 10, 20, 30, 0});
  for (const Rgb& p : read_texture(path, "texture.file").pixels) {
    EXPECT_EQ(p, fractions<std::uint8_t>(10, 20, 30));
  }
}

TEST(ReadTexture, alpha_of_a_sixteen_bit_image_is_left_out_and_not_multiplied_in) {
  const TemporaryFolder folder;
  const auto path = written<std::uint16_t>(folder, "t.png", 2, 1, 4,
                                           {1000, 2001, 40003, 65535, 1000, 2001, 40003, 7});
  for (const Rgb& p : read_texture(path, "texture.file").pixels) {
    EXPECT_EQ(p, fractions<std::uint16_t>(1000, 2001, 40003));
  }
}

TEST(ReadTexture, exr_values_in_range_are_kept_to_sixteen_bits) {
  const TemporaryFolder folder;
  const auto path = written<float>(folder, "t.exr", 2, 1, 3, {0, 0.3f, 1, 0.123456f, 0.5f, 0.75f});
  const TextureImage read = read_texture(path, "texture.file");
  EXPECT_EQ(read.pixels[0].r, 0);
  EXPECT_EQ(read.pixels[0].b, 1);
  EXPECT_NEAR(read.pixels[1].r, 0.123456, 0.5 / 65535 + 1e-7);  // half a step, and float32
  EXPECT_NEAR(read.pixels[0].g, 0.3, 0.5 / 65535 + 1e-7);
}

TEST(ReadTexture, texture_read_is_what_its_own_png_holds) {
  const TemporaryFolder folder;
  const auto path = written<float>(folder, "t.exr", 2, 1, 3, {0, 0.3f, 1, 0.123456f, 0.5f, 0.75f});
  const TextureImage read = read_texture(path, "texture.file");
  const auto again = folder.file("t.png", texture_png(read));
  EXPECT_EQ(read_texture(again, "texture.file").pixels, read.pixels);
}

TEST(ReadTexture, values_outside_the_unit_interval_are_refused_naming_the_texel) {
  const TemporaryFolder folder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {-0.25f, 1.5f, nan, std::numeric_limits<float>::infinity()}) {
    std::vector<float> values(3 * 4 * 3, 0.5f);
    values[3 * (2 * 4 + 1) + 1] = bad;  // green of texel (1, 2)
    const auto path = written<float>(folder, "t.exr", 4, 3, 3, values);
    const std::string error = error_of([&] { read_texture(path, "texture.file"); });
    EXPECT_THAT(error, HasSubstr("texture.file")) << bad;
    EXPECT_THAT(error, HasSubstr("(1, 2)")) << bad;
  }
}

TEST(ReadTexture, files_that_are_not_images_are_refused_naming_the_label_and_the_file) {
  const TemporaryFolder folder;
  const std::string png = texture_png(bricks());
  const std::pair<const char*, std::string> cases[] = {{"empty.png", ""},
                                                       {"garbage.png", "only words"},
                                                       {"garbage.exr", "only words"},
                                                       {"words.txt", "only words"},
                                                       {"cut.png", png.substr(0, png.size() / 2)}};
  for (const auto& [name, text] : cases) {
    const auto path = folder.file(name, text);
    const std::string error = error_of([&] { read_texture(path, "texture.file"); });
    EXPECT_THAT(error, HasSubstr("texture.file")) << name;
    EXPECT_THAT(error, HasSubstr(name)) << name;
  }
  const std::string missing =
      error_of([&] { read_texture(folder / "missing.png", "texture.file"); });
  EXPECT_THAT(missing, HasSubstr("missing.png can't be read as a texture: No such file"));
  EXPECT_THAT(error_of([&] { read_texture(folder / ".", "texture.file"); }),
              HasSubstr("Is a directory"));
}

}  // namespace
}  // namespace lumaknot
