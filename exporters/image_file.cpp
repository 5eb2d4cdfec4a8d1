#include "exporters/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "scene/atomic_file.h"
#include "scene/error.h"

namespace lumaknot {
namespace {

constexpr long long kMostTexels = 1LL << 28;

std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& path) {
  // Unassociated alpha would otherwise be multiplied into colours that are used as they are.
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;
  auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) throw std::runtime_error(OIIO::geterror());
  return input;
}

/// Standard error closed for a while: libpng writes there what we tell in our own words.
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

std::vector<float> read_floats(OIIO::ImageInput& input) {
  const OIIO::ImageSpec& spec = input.spec();
  std::vector<float> values(std::size_t(spec.width) * spec.height * spec.nchannels);
  if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, values.data())) {
    throw std::runtime_error(input.geterror());
  }
  return values;
}

/// Integers of `bits` bits nearest to a value in [0, 1].
template <class Integer>
Integer quantised(float value) {
  constexpr float kMost = float(std::numeric_limits<Integer>::max());
  return Integer(std::lround(std::clamp(value, 0.0f, 1.0f) * kMost));
}

bool is_eight_bit(float v) { return float(quantised<std::uint8_t>(v)) / 255.0f == v; }

bool is_eight_bit(const TextureImage& texture) {
  return std::ranges::all_of(texture.pixels, [](const Rgb& p) {
    return is_eight_bit(p.r) && is_eight_bit(p.g) && is_eight_bit(p.b);
  });
}

/// The bytes of a PNG file; `values` are width * height * channels integers.
template <class Integer>
std::string encode_png(int width, int height, int channels, const std::vector<Integer>& values,
                       int compression = 6) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  auto output = OIIO::ImageOutput::create("memory.png");
  OIIO::ImageSpec spec(width, height, channels, OIIO::BaseTypeFromC<Integer>::value);
  spec["oiio:Gamma"] = 1.0f;
  spec["oiio:UnassociatedAlpha"] = 1;
  spec["png:compressionLevel"] = compression;
  output->set_ioproxy(&memory);
  if (!output->open("memory.png", spec) || !output->write_image(spec.format, values.data()) ||
      !output->close()) {
    throw std::runtime_error("PNG: " + output->geterror());
  }
  return {bytes.begin(), bytes.end()};
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

/// Floats without the present moment, which the writer would else put into the file.
OIIO::ImageSpec exr_spec(int width, int height, int channels) {
  OIIO::ImageSpec spec(width, height, channels, OIIO::TypeFloat);
  spec["DateTime"] = "1970:01:01 00:00:00";
  return spec;
}

void write_exr(const std::filesystem::path& path, const Image& image) {
  auto output = OIIO::ImageOutput::create(path.string());
  const OIIO::ImageSpec spec = exr_spec(image.width, image.height, 4);
  if (!output || !output->open(path.string(), spec) ||
      !output->write_image(OIIO::TypeFloat, image.pixels.data()) || !output->close()) {
    throw Error(
        fmt::format("{}: {}", path.string(), output ? output->geterror() : OIIO::geterror()));
  }
}

/// 16 bits a channel; PNG keeps colours unmultiplied by alpha.
std::string rgba_png(const Image& image) {
  std::vector<std::uint16_t> values;
  values.reserve(4 * image.pixels.size());
  for (const RgbaPixel& p : image.pixels) {
    const float scale = p.coverage > 0 ? 1 / p.coverage : 0;
    for (const float v : {p.color.r * scale, p.color.g * scale, p.color.b * scale, p.coverage}) {
      values.push_back(quantised<std::uint16_t>(v));
    }
  }
  return encode_png(image.width, image.height, 4, values);
}

}  // namespace

TextureImage read_texture(const std::filesystem::path& path, std::string_view label) try {
  const QuietStandardError quiet;
  auto input = open_image(path);
  const int width = input->spec().width, height = input->spec().height;
  const int channels = input->spec().nchannels;
  if (1LL * width * height > kMostTexels || input->spec().depth > 1) {
    throw std::runtime_error(fmt::format("{} x {} texels are too many", width, height));
  }
  const std::vector<float> values = read_floats(*input);
  const bool is_grey = channels < 3;
  TextureImage texture(width, height);
  for (std::size_t i = 0; i < texture.pixels.size(); ++i) {
    const float* v = &values[i * std::size_t(channels)];
    float rgb[3];
    for (int c = 0; c < 3; ++c) {
      rgb[c] = v[is_grey ? 0 : c];
      if (!(rgb[c] >= 0 && rgb[c] <= 1)) {
        throw std::runtime_error(
            fmt::format("texel ({}, {}) holds {}, outside [0, 1]", i % width, i / width, rgb[c]));
      }
      if (!is_eight_bit(rgb[c])) rgb[c] = float(quantised<std::uint16_t>(rgb[c])) / 65535.0f;
    }
    texture.pixels[i] = {rgb[0], rgb[1], rgb[2]};
  }
  return texture;
} catch (const std::runtime_error& e) {
  throw Error(fmt::format("{} {} can't be read as a texture: {}", label, path.string(), e.what()));
}

std::string texture_png(const TextureImage& texture) {
  return is_eight_bit(texture)
             ? encode_png(texture.width, texture.height, 3, interleaved<std::uint8_t>(texture))
             : encode_png(texture.width, texture.height, 3, interleaved<std::uint16_t>(texture));
}

std::string texture_exr(const TextureImage& texture) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  auto output = OIIO::ImageOutput::create("memory.exr");
  const OIIO::ImageSpec spec = exr_spec(texture.width, texture.height, 3);
  output->set_ioproxy(&memory);
  if (!output->open("memory.exr", spec) ||
      !output->write_image(OIIO::TypeFloat, texture.pixels.data()) || !output->close()) {
    throw std::runtime_error("EXR: " + output->geterror());
  }
  return {bytes.begin(), bytes.end()};
}

std::string grey_png(const Grid<float>& values) {
  std::vector<std::uint16_t> integers(values.pixels.size());
  std::ranges::transform(values.pixels, integers.begin(),
                         [](float v) { return quantised<std::uint16_t>(v); });
  return encode_png(values.width, values.height, 1, integers);
}

std::string display_png(const Image& image) {
  std::vector<std::uint8_t> values;
  values.reserve(3 * image.pixels.size());
  for (const RgbaPixel& p : image.pixels) {
    for (const float v : {p.color.r, p.color.g, p.color.b}) {
      values.push_back(quantised<std::uint8_t>(v));
    }
  }
  constexpr int kFast = 2;  // a report holds dozens of these
  return encode_png(image.width, image.height, 3, values, kFast);
}

void check_image_extension(const std::filesystem::path& path, std::string_view flag) {
  if (path.extension() == ".exr" || path.extension() == ".png") return;
  throw Error(fmt::format("{} {} must end in .exr or .png", flag, path.string()));
}

void write_image(const std::filesystem::path& path, const Image& image, std::string_view flag) {
  check_image_extension(path, flag);
  if (path.extension() == ".png") {
    write_file(path, rgba_png(image), flag);
    return;
  }
  AtomicFile file(path, flag);
  write_exr(file.temporary(), image);
  file.commit();
}

Image read_image(const std::filesystem::path& path, int width, int height) {
  auto input = open_image(path);
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width != width || spec.height != height || spec.nchannels != 4) {
    throw std::runtime_error(fmt::format("{} is {} x {} with {} channels, not {} x {} with 4",
                                         path.filename().string(), spec.width, spec.height,
                                         spec.nchannels, width, height));
  }
  const std::vector<float> values = read_floats(*input);
  const bool unassociated = std::string_view(input->format_name()) == "png";
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float* v = &values[4 * i];
    const float scale = unassociated ? v[3] : 1;
    image.pixels[i] = {{v[0] * scale, v[1] * scale, v[2] * scale}, v[3]};
  }
  return image;
}

}  // namespace lumaknot
