// Rendered images: float32 in EXR, limited in PNG.
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

#include "exporters/image/file.h"
#include "tests/exporters/testing.h"

namespace lumaknot {
namespace {

using testing::bytes_at;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::TemporaryFolder;

/// 3 x 2 pixels with negative, large and awkward values, none of which is exact in half floats.
Image drawn() {
  Image image(3, 2);
  image.pixels = {{{0.1f, 0.2f, 0.3f}, 1},
                  {{-0.05f, 1.75f, 1e-7f}, 1},
                  {{0.12345678f, 0.98765432f, 65537.0f}, 1},
                  {{0, 0, 0}, 0},
                  {{0.25f, 0.125f, 0.0f}, 0.5f},
                  {{-3.0f, 1e9f, 0.333333f}, 1.0f / 9}};
  return image;
}

void expect_same(const Image& a, const Image& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    EXPECT_EQ(a.pixels[i].color, b.pixels[i].color) << i;
    EXPECT_EQ(a.pixels[i].coverage, b.pixels[i].coverage) << i;
  }
}

TEST(WriteImage, exr_is_read_back_exactly) {
  const TemporaryFolder folder;
  write_image(folder / "i.exr", drawn(), "--output");
  expect_same(read_image(folder / "i.exr", 3, 2), drawn());
}

TEST(WriteImage, png_of_whole_pixels_is_read_back_limited_to_sixteen_bits) {
  const TemporaryFolder folder;
  Image image(4, 1);
  image.pixels = {{{0.1f, 0.2f, 0.3f}, 1}, {{-0.5f, 1.5f, 1}, 1}, {{0, 0.5f, 0.25f}, 1}, {}};
  write_image(folder / "i.png", image, "--output");
  const Image read = read_image(folder / "i.png", 4, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d a = to_vec(read.pixels[i].color), b = to_vec(image.pixels[i].color);
    constexpr double kHalfStep = 0.5 / 65535 + 1e-7;  // of 16 bits, and float32
    EXPECT_NEAR(a.x, std::clamp(b.x, 0.0, 1.0), kHalfStep);
    EXPECT_NEAR(a.y, std::clamp(b.y, 0.0, 1.0), kHalfStep);
    EXPECT_NEAR(a.z, std::clamp(b.z, 0.0, 1.0), kHalfStep);
    EXPECT_EQ(read.pixels[i].coverage, image.pixels[i].coverage);
  }
}

TEST(WriteImage, png_holds_colors_that_are_not_multiplied_by_the_coverage) {
  const TemporaryFolder folder;
  Image image(1, 1);
  image.pixels = {{{0.25f, 0.125f, 0.5f}, 0.5f}};
  write_image(folder / "i.png", image, "--output");
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;
  auto input = OIIO::ImageInput::open((folder / "i.png").string(), &config);
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().format, OIIO::TypeUInt16);
  float v[4];
  ASSERT_TRUE(input->read_image(0, 0, 0, 4, OIIO::TypeFloat, v));
  const float expected[] = {0.5f, 0.25f, 1, 0.5f};  // 0.5 is not a multiple of 1/65535
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(v[c], expected[c], 0.5 / 65535 + 1e-7) << c;
}

class ImageFormat : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(, ImageFormat, ::testing::Values(".exr", ".png"),
                         [](const auto& format) { return std::string(format.param + 1); });

TEST_P(ImageFormat, writing_twice_gives_the_same_bytes) {
  const TemporaryFolder folder;
  const auto a = folder / (std::string("a") + GetParam());
  const auto b = folder / (std::string("b") + GetParam());
  write_image(a, drawn(), "--output");
  write_image(b, drawn(), "--output");
  EXPECT_EQ(bytes_at(a), bytes_at(b));
  EXPECT_FALSE(bytes_at(a).empty());
}

/// Today in the formats' notation.
std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  return {text, std::strftime(text, sizeof text, "%Y:%m:%d", std::localtime(&now))};
}

TEST_P(ImageFormat, file_holds_no_time_and_no_path) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("unmistakable") + GetParam());
  const std::string before = today();
  write_image(path, drawn(), "--output");
  const std::string bytes = bytes_at(path);
  // Midnight may pass in between.
  for (const std::string& part : {before, today(), std::string("tIME"), folder.path().string(),
                                  std::string("unmistakable"), std::string("HostComputer")}) {
    EXPECT_EQ(bytes.find(part), bytes.npos) << part;
  }
}

TEST_P(ImageFormat, written_file_replaces_the_old_one_and_leaves_nothing_else) {
  const TemporaryFolder folder;
  const std::string name = std::string("i") + GetParam();
  const auto path = folder.file(name, "old");
  write_image(path, drawn(), "--output");
  EXPECT_THAT(folder.names(), ElementsAre(name));
  EXPECT_EQ(read_image(path, 3, 2).pixels.size(), 6u);
}

TEST_P(ImageFormat, place_that_cannot_be_written_is_refused_naming_the_flag) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("missing/i") + GetParam());
  const std::string error = error_of([&] { write_image(path, drawn(), "--output"); });
  EXPECT_THAT(error, HasSubstr("--output"));
  EXPECT_THAT(error, HasSubstr(path.string()));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(WriteImage, unknown_extension_is_refused_and_the_old_file_kept) {
  const TemporaryFolder folder;
  for (const char* name : {"i.jpg", "i", "i.tiff", "i.exr2", ".png"}) {
    const auto path = folder.file(name, "old");
    const std::string error = error_of([&] { write_image(path, drawn(), "--output"); });
    EXPECT_THAT(error, HasSubstr("--output")) << name;
    EXPECT_THAT(error, HasSubstr(".exr or .png")) << name;
    EXPECT_EQ(bytes_at(path), "old") << name;
  }
}

TEST(ReadImage, another_size_is_refused_naming_both) {
  const TemporaryFolder folder;
  write_image(folder / "i.exr", drawn(), "--output");
  for (const auto& [width, height] : {std::pair{2, 3}, {3, 3}, {4, 2}, {0, 0}}) {
    try {
      read_image(folder / "i.exr", width, height);
      ADD_FAILURE() << width << " x " << height << " was accepted";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("3 x 2"));
      EXPECT_THAT(error.what(), HasSubstr(std::to_string(width) + " x " + std::to_string(height)));
    }
  }
}

TEST(ReadImage, image_without_alpha_is_refused) {
  const TemporaryFolder folder;
  folder.file("i.png", display_png(drawn()));
  EXPECT_THROW(read_image(folder / "i.png", 3, 2), std::runtime_error);
}

TEST(ReadImage, files_that_are_not_images_are_refused) {
  const TemporaryFolder folder;
  write_image(folder / "whole.exr", drawn(), "--output");
  const std::string whole = bytes_at(folder / "whole.exr");
  folder.file("cut.exr", std::string_view(whole).substr(0, whole.size() - 20));
  folder.file("empty.exr", "");
  folder.file("words.exr", "only words");
  for (const char* name : {"cut.exr", "empty.exr", "words.exr", "missing.exr"}) {
    EXPECT_THROW(read_image(folder / name, 3, 2), std::runtime_error) << name;
  }
}

TEST(DisplayPng, decodes_to_the_image_limited_to_eight_bits) {
  const TemporaryFolder folder;
  const TextureImage read =
      read_texture(folder.file("d.png", display_png(drawn())), "texture.file");
  ASSERT_EQ(read.width, 3);
  ASSERT_EQ(read.height, 2);
  for (std::size_t i = 0; i < read.pixels.size(); ++i) {
    const Vec3d a = to_vec(read.pixels[i]), b = to_vec(drawn().pixels[i].color);
    constexpr double kHalfStep = 0.5 / 255 + 1e-7;  // of 8 bits, and float32
    EXPECT_NEAR(a.x, std::clamp(b.x, 0.0, 1.0), kHalfStep);
    EXPECT_NEAR(a.y, std::clamp(b.y, 0.0, 1.0), kHalfStep);
    EXPECT_NEAR(a.z, std::clamp(b.z, 0.0, 1.0), kHalfStep);
  }
}

TEST(DisplayPng, gives_the_same_bytes_twice) {
  EXPECT_EQ(display_png(drawn()), display_png(drawn()));
}

TEST(Base64, matches_the_test_vectors_of_rfc_4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

}  // namespace
}  // namespace lumaknot
