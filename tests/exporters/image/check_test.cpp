// Files that are not whole images, refused before an image library is used.
#include "exporters/image/check.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exporters/image/file.h"
#include "scene/bricks.h"
#include "tests/exporters/testing.h"

namespace lumaknot {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using testing::TemporaryFolder;

/// The message of check_image_bytes() for `bytes`; empty: none.
std::string problem_of(std::string_view bytes) {
  try {
    check_image_bytes(bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// A noisy image as OpenImageIO writes it in the format of `extension`.
std::string image_bytes(const std::string& extension, const std::string& compression = "") {
  const TemporaryFolder folder;
  const std::string path = (folder / "image").string() + extension;
  constexpr int kWidth = 37, kHeight = 29;
  OIIO::ImageSpec spec(kWidth, kHeight, 3, OIIO::TypeUInt8);
  if (!compression.empty()) spec["Compression"] = compression;
  std::vector<std::uint8_t> values;
  for (int i = 0; i < 3 * kWidth * kHeight; ++i) values.push_back(std::uint8_t(i * i % 251));
  const auto output = OIIO::ImageOutput::create(path);
  EXPECT_TRUE(output && output->open(path, spec) &&
              output->write_image(spec.format, values.data()) && output->close());
  return testing::bytes_at(path);
}

/// The bytes of a chunk of a PNG file, with an arbitrary checksum.
std::string chunk(const std::string& name, const std::string& content) {
  return std::string("\0\0\0", 3) + char(content.size()) + name + content + "sum.";
}

std::string png_of(const std::string& chunks) { return "\x89PNG\r\n\x1A\n" + chunks; }

const std::string kHeader = chunk("IHDR", std::string(13, '\1'));
const std::string kData = chunk("IDAT", "pixels"), kEnd = chunk("IEND", "");

TEST(CheckImage, whole_images_pass) {
  for (const char* extension : {".png", ".jpg", ".tif", ".exr", ".bmp", ".gif", ".tga", ".hdr",
                                ".webp", ".ppm", ".sgi", ".dpx"}) {
    EXPECT_EQ(problem_of(image_bytes(extension)), "") << extension;
  }
  for (const char* compression : {"none", "zip", "lzw", "packbits"}) {
    EXPECT_EQ(problem_of(image_bytes(".tif", compression)), "") << compression;
  }
  for (const char* compression : {"none", "rle", "zips", "piz"}) {
    EXPECT_EQ(problem_of(image_bytes(".exr", compression)), "") << compression;
  }
  EXPECT_EQ(problem_of(texture_png(bricks())), "");
  EXPECT_EQ(problem_of(texture_exr(bricks())), "");
}

TEST(CheckImage, bytes_after_the_end_are_ignored) {
  EXPECT_EQ(problem_of(image_bytes(".png") + "more"), "");
  EXPECT_EQ(problem_of(image_bytes(".jpg") + "more"), "");
}

TEST(CheckImage, every_shorter_file_is_refused_with_the_byte) {
  for (const char* extension : {".png", ".jpg", ".exr"}) {
    const std::string whole = image_bytes(extension);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_THAT(problem_of(whole.substr(0, size)), StartsWith("byte ")) << extension << size;
    }
  }
}

TEST(CheckImage, tiff_files_whose_pixels_are_cut_are_refused) {
  for (const char* compression : {"none", "zip"}) {
    const std::string whole = image_bytes(".tif", compression);
    EXPECT_THAT(problem_of(whole.substr(0, whole.size() / 2)), HasSubstr("cut short"));
  }
}

TEST(CheckImage, files_that_are_not_images_are_reported_at_their_beginning) {
  for (const std::string& bytes :
       {std::string("only words"), std::string(1000, '\0'), std::string("solid mesh\nfacet"),
        std::string("glTF"), std::string("\x89PN"), std::string(1000, '\xFF')}) {
    EXPECT_THAT(problem_of(bytes), StartsWith("byte 0: not the beginning of a supported image"));
  }
}

TEST(CheckImage, png_files_need_their_chunks) {
  const std::pair<std::string, const char*> cases[] = {
      {kHeader + kData + kEnd, ""},
      {"", "byte 8: 4 bytes expected at byte 8"},
      {kData + kEnd, "byte 8: IHDR must be the first chunk"},
      {kHeader + kHeader, "byte 33: IHDR must be the first chunk"},
      {kHeader + kEnd, "byte 33: the image ends without IDAT"},
      {kHeader + kData, "byte 51: 4 bytes expected at byte 51; the file is cut short"},
      {kHeader + std::string("\xFF\xFF\xFF\xFFIDATpixels", 14),
       "byte 33: a chunk of 4294967307 bytes, of which 14 exist"},
      {kHeader + kData + std::string("\0\0\0\0IEND\0\0\0", 11),
       "byte 51: a chunk of 12 bytes, of which 11 exist"}};
  for (const auto& [chunks, problem] : cases) {
    EXPECT_THAT(problem_of(png_of(chunks)), StartsWith(problem));
  }
}

TEST(CheckImage, jpeg_files_need_their_end) {
  const std::string begin = "\xFF\xD8", end = "\xFF\xD9";
  const std::string scan("\xFF\xDA\0\3s\1\xFF\0\2\xFF\xD0\3\xFF",
                         13);                            // stuffed, restarted, filled
  const std::string segment("\xFF\xE0\0\4\xFF\xD9", 6);  // which contains no end
  const std::pair<std::string, const char*> cases[] = {
      {begin + segment + scan + end, ""},
      {begin + segment + scan, "byte 21: the image's end marker is missing"},
      {begin + segment + end, "byte 8: the image ends without a scan"},
      {begin + segment + std::string("\xFF\xDA\1\0s", 5),
       "byte 10: a segment of 256 bytes, of which 3 exist"}};
  for (const auto& [bytes, problem] : cases) EXPECT_THAT(problem_of(bytes), StartsWith(problem));
}

TEST(CheckImage, changed_bytes_pass_or_are_refused_with_a_byte) {
  for (const char* extension : {".png", ".jpg", ".tif", ".exr"}) {
    const std::string whole = image_bytes(extension);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      for (const char value : {'\0', '\x7F', '\xFF'}) {
        std::string changed = whole;
        changed[i] = value;
        const std::string problem = problem_of(changed);
        EXPECT_TRUE(problem.empty() || problem.starts_with("byte ")) << problem;
      }
    }
  }
}

TEST(CheckImage, cut_textures_are_refused_though_a_library_would_accept_them) {
  const TemporaryFolder folder;
  for (const char* name : {"cut.jpg", "cut.tif", "cut.png", "cut.exr"}) {
    std::string bytes = image_bytes(std::filesystem::path(name).extension().string());
    bytes.resize(bytes.size() * 9 / 10);
    const auto path = folder.file(name, bytes);
    for (const auto& read : {+[](const std::filesystem::path& p) { check_texture_file(p, "t"); },
                             +[](const std::filesystem::path& p) { read_texture(p, "t"); }}) {
      EXPECT_THAT(error_of([&] { read(path); }),
                  AllOf(StartsWith("t "), HasSubstr(name), HasSubstr(": byte "),
                        HasSubstr("cut short"), Not(HasSubstr("\n"))));
    }
  }
}

}  // namespace
}  // namespace lumaknot
