/// Image files through OpenImageIO, as a table of functions. It is a module of its own since
/// OpenImageIO brings about 250 libraries: module.h loads it when the first image is needed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lumaknot {

/// The size of an image in a file: samples are row by row from the top left, channels interleaved.
struct ImageSize {
  int width = 0, height = 0, channels = 0;
  int depth = 1;  ///< more for volumes
};

/// An image as stored in a file, integers divided by their largest value.
struct DecodedImage {
  ImageSize size;
  bool is_png = false;        ///< colours are then not multiplied by alpha
  std::vector<float> values;  ///< width * height * channels
};

/// The module's functions. All throw std::runtime_error with OpenImageIO's message. `values` are
/// width * height * channels samples, written unchanged.
struct ImageCodec {
  /// The image in the file at `path`. `check` sees the size before memory is allocated, and may
  /// throw.
  DecodedImage (*decode)(const std::filesystem::path& path,
                         const std::function<void(const ImageSize&)>& check);
  /// The bytes of a PNG file; `compression` is zlib's level, 1 to 9.
  std::string (*encode_png8)(const ImageSize& size, std::span<const std::uint8_t> values,
                             int compression);
  std::string (*encode_png16)(const ImageSize& size, std::span<const std::uint16_t> values,
                              int compression);
  /// The bytes of an EXR file of 32-bit floats.
  std::string (*encode_exr)(const ImageSize& size, std::span<const float> values);
  std::string (*base64)(std::string_view bytes);
};

}  // namespace lumaknot

/// The only exported function of the module.
extern "C" const lumaknot::ImageCodec* lumaknot_image_codec();
