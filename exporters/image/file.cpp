#include "exporters/image/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "exporters/image/check.h"
#include "exporters/image/module.h"
#include "system/atomic_file.h"
#include "system/error.h"

namespace lumaknot {
namespace {

constexpr long long kMaxTexels = 1LL << 28;
constexpr int kSmall = 6;  // zlib's usual level
constexpr int kFast = 2;   // a report holds dozens of pictures

/// Standard error closed for a while: libpng writes there what our own messages say.
class QuietStandardError {
 public:
  QuietStandardError() : saved_(::dup(STDERR_FILENO)), null_(::open("/dev/null", O_WRONLY)) {
    ::dup2(null_, STDERR_FILENO);
  }
  ~QuietStandardError() {
    ::dup2(saved_, STDERR_FILENO);
    ::close(saved_);
    ::close(null_);
  }
  QuietStandardError(const QuietStandardError&) = delete;
  QuietStandardError& operator=(const QuietStandardError&) = delete;

 private:
  int saved_, null_;
};

/// Integers of `bits` bits, nearest to a value in [0, 1].
template <class Integer>
Integer quantised(float value) {
  constexpr float kMax = float(std::numeric_limits<Integer>::max());
  return Integer(std::lround(std::clamp(value, 0.0f, 1.0f) * kMax));
}

bool is_eight_bit(float v) { return float(quantised<std::uint8_t>(v)) / 255.0f == v; }

bool is_eight_bit(const TextureImage& texture) {
  return std::ranges::all_of(texture.pixels, [](const Rgb& p) {
    return is_eight_bit(p.r) && is_eight_bit(p.g) && is_eight_bit(p.b);
  });
}

template <class Integer>
std::vector<Integer> interleaved(const TextureImage& texture) {
  std::vector<Integer> values;
  values.reserve(3 * texture.pixels.size());
  for (const Rgb& p : texture.pixels) {
    for (const float v : {p.r, p.g, p.b}) values.push_back(quantised<Integer>(v));
  }
  return values;
}

/// 16 bits per channel; PNG stores colours not multiplied by alpha.
std::string rgba_png(const Image& image) {
  std::vector<std::uint16_t> values;
  values.reserve(4 * image.pixels.size());
  for (const RgbaPixel& p : image.pixels) {
    const float scale = p.coverage > 0 ? 1 / p.coverage : 0;
    for (const float v : {p.color.r * scale, p.color.g * scale, p.color.b * scale, p.coverage}) {
      values.push_back(quantised<std::uint16_t>(v));
    }
  }
  return image_codec().encode_png16({image.width, image.height, 4}, values, kSmall);
}

/// The numbers of all pixels, one after another.
template <class Pixel>
std::span<const float> floats(const Grid<Pixel>& grid) {
  constexpr std::size_t kNumbers = sizeof(Pixel) / sizeof(float);
  return {reinterpret_cast<const float*>(grid.pixels.data()), kNumbers * grid.pixels.size()};
}

[[noreturn]] void refuse(std::string_view label, const std::filesystem::path& path,
                         std::string_view why, std::string_view what = "texture") {
  if (why.empty()) why = "it is cut short or damaged";  // OpenImageIO does not always give a reason
  throw Error(fmt::format("{} {} can't be read as a {}: {}", label, path.string(), what, why));
}

void check_texture_size(const ImageSize& size) {
  if (1LL * size.width * size.height <= kMaxTexels && size.depth <= 1) return;
  throw std::runtime_error(fmt::format("{} x {} texels are too many", size.width, size.height));
}

/// Multiples of 1/255 unchanged, other numbers in [0, 1] rounded to 1/65535.
float texel_value(float v) {
  return is_eight_bit(v) ? v : float(quantised<std::uint16_t>(v)) / 65535.0f;
}

/// The texture in an image of any number of channels: one or two are grey and alpha.
TextureImage texture_in(const DecodedImage& image) {
  const int width = image.size.width, channels = image.size.channels;
  const bool is_grey = channels < 3;
  TextureImage texture(width, image.size.height);
  for (std::size_t i = 0; i < texture.pixels.size(); ++i) {
    const float* v = &image.values[i * std::size_t(channels)];
    const Rgb texel = is_grey ? Rgb{v[0], v[0], v[0]} : Rgb{v[0], v[1], v[2]};
    for (const float value : {texel.r, texel.g, texel.b}) {
      if (value >= 0 && value <= 1) continue;
      throw std::runtime_error(
          fmt::format("texel ({}, {}) holds {}, outside [0, 1]", i % width, i / width, value));
    }
    texture.pixels[i] = {texel_value(texel.r), texel_value(texel.g), texel_value(texel.b)};
  }
  return texture;
}

}  // namespace

namespace {

/// Throws refuse()'s Error if the file is empty, not an image or cut short.
void check_image_file(const std::filesystem::path& path, std::string_view label,
                      std::string_view what) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (stream.peek() == std::ifstream::traits_type::eof()) {
    refuse(label, path, errno ? std::strerror(errno) : "it is empty", what);
  }
  try {
    check_image_bytes(read_file(path, label));
  } catch (const std::runtime_error& e) {
    refuse(label, path, e.what(), what);
  }
}

/// The picture in an image of any number of channels.
Image picture_in(const DecodedImage& read) {
  const int channels = read.size.channels;
  const bool is_grey = channels < 3, has_alpha = channels == 2 || channels >= 4;
  Image image(read.size.width, read.size.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float* v = &read.values[i * std::size_t(channels)];
    const float alpha = has_alpha ? v[is_grey ? 1 : 3] : 1;
    const float scale = read.is_png ? alpha : 1;
    const Rgb color = is_grey ? Rgb{v[0], v[0], v[0]} : Rgb{v[0], v[1], v[2]};
    image.pixels[i] = {{color.r * scale, color.g * scale, color.b * scale}, alpha};
    for (const float value : {color.r, color.g, color.b, alpha}) {
      if (std::isfinite(value)) continue;
      throw std::runtime_error(fmt::format("pixel ({}, {}) holds {}", int(i) % image.width,
                                           int(i) / image.width, value));
    }
  }
  return image;
}

}  // namespace

void check_texture_file(const std::filesystem::path& path, std::string_view label) {
  check_image_file(path, label, "texture");
}

Image read_picture(const std::filesystem::path& path, std::string_view label) {
  check_image_file(path, label, "picture");
  try {
    const QuietStandardError quiet;
    return picture_in(image_codec().decode(path, check_texture_size));
  } catch (const std::runtime_error& e) {
    refuse(label, path, e.what(), "picture");
  }
}

TextureImage read_texture(const std::filesystem::path& path, std::string_view label) {
  check_texture_file(path, label);
  const ImageCodec& codec = image_codec();
  try {
    const QuietStandardError quiet;
    return texture_in(codec.decode(path, check_texture_size));
  } catch (const std::runtime_error& e) {
    refuse(label, path, e.what());
  }
}

std::string texture_png(const TextureImage& texture) {
  const ImageCodec& codec = image_codec();
  const ImageSize size{texture.width, texture.height, 3};
  return is_eight_bit(texture)
             ? codec.encode_png8(size, interleaved<std::uint8_t>(texture), kSmall)
             : codec.encode_png16(size, interleaved<std::uint16_t>(texture), kSmall);
}

std::string texture_exr(const TextureImage& texture) {
  return image_codec().encode_exr({texture.width, texture.height, 3}, floats(texture));
}

std::string grey_png(const Grid<float>& values) {
  std::vector<std::uint16_t> integers(values.pixels.size());
  std::ranges::transform(values.pixels, integers.begin(),
                         [](float v) { return quantised<std::uint16_t>(v); });
  return image_codec().encode_png16({values.width, values.height, 1}, integers, kSmall);
}

std::string display_png(const Image& image) {
  std::vector<std::uint8_t> values;
  values.reserve(3 * image.pixels.size());
  for (const RgbaPixel& p : image.pixels) {
    for (const float v : {p.color.r, p.color.g, p.color.b}) {
      values.push_back(quantised<std::uint8_t>(v));
    }
  }
  return image_codec().encode_png8({image.width, image.height, 3}, values, kFast);
}

std::string smallest_png(int width, int height, int channels,
                         std::span<const std::uint8_t> samples) {
  return image_codec().encode_png8({width, height, channels}, samples, kSmall);
}

void check_image_extension(const std::filesystem::path& path, std::string_view flag) {
  constexpr std::array<std::string_view, 2> kEndings{".exr", ".png"};
  check_ending(path, kEndings, flag);
}

void write_image(const std::filesystem::path& path, const Image& image, std::string_view flag) {
  check_image_extension(path, flag);
  if (path.extension() == ".png") {
    write_file(path, rgba_png(image), flag);
    return;
  }
  const ImageSize size{image.width, image.height, 4};
  write_file(path, image_codec().encode_exr(size, floats(image)), flag);
}

Image read_image(const std::filesystem::path& path, int width, int height) {
  const DecodedImage read = image_codec().decode(path, [&](const ImageSize& size) {
    if (size.width == width && size.height == height && size.channels == 4) return;
    throw std::runtime_error(fmt::format("{} is {} x {} with {} channels, not {} x {} with 4",
                                         path.filename().string(), size.width, size.height,
                                         size.channels, width, height));
  });
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float* v = &read.values[4 * i];
    const float scale = read.is_png ? v[3] : 1;
    image.pixels[i] = {{v[0] * scale, v[1] * scale, v[2] * scale}, v[3]};
  }
  return image;
}

std::string base64(std::string_view bytes) { return image_codec().base64(bytes); }

}  // namespace lumaknot
