/// Images in files, through OpenImageIO, which is loaded when the first of these functions needs
/// it; they throw Error when that fails. Values are read and written unchanged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene/image.h"

namespace lumaknot {

/// The texture in an image file: grey becomes r = g = b, alpha is dropped. Values that are not
/// multiples of 1/255 are kept to 1/65535, so that a 16-bit file passes them on exactly. Throws
/// Error calling the file `label` when it can't be read or has values outside [0, 1].
TextureImage read_texture(const std::filesystem::path& path, std::string_view label);

/// Throws read_texture()'s Error when the file at `path` is empty, not an image or, for PNG, JPEG,
/// TIFF and OpenEXR, cut short. Does not load an image library.
void check_texture_file(const std::filesystem::path& path, std::string_view label);

/// The texture as a PNG file's bytes: 8 bits where that is exact, else 16.
std::string texture_png(const TextureImage& texture);

/// The texture as a float EXR file's bytes.
std::string texture_exr(const TextureImage& texture);

/// Values of a grid in [0, 1] as the bytes of a grey PNG file, 16 bits.
std::string grey_png(const Grid<float>& values);

/// A rendered image as the bytes of a PNG file for viewing: 8 bits, limited to [0, 1], over black.
std::string display_png(const Image& image);

/// Samples of 8 bits, row by row with `channels` (1 or 3) interleaved, as the bytes of the smallest
/// PNG file that holds them unchanged.
std::string smallest_png(int width, int height, int channels,
                         std::span<const std::uint8_t> samples);

/// Writes a rendered image as .exr (float32, unlimited) or .png (16 bits, limited to [0, 1]), both
/// with the coverage as alpha. The file is written whole or not at all; `flag` names it in an
/// Error.
void write_image(const std::filesystem::path& path, const Image& image, std::string_view flag);

/// Throws Error, naming `flag`, unless write_image() knows the extension of `path`.
void check_image_extension(const std::filesystem::path& path, std::string_view flag);

/// The rendered image in a file with red, green, blue and alpha. Throws std::runtime_error when it
/// is missing, does not decode or has another size.
Image read_image(const std::filesystem::path& path, int width, int height);

/// The picture in a file of any size that another program wrote: colours multiplied by alpha; the
/// coverage is 1 where there is none. One or two channels are grey and alpha. Throws Error calling
/// it `label` when it can't be read or has values that are not finite.
Image read_picture(const std::filesystem::path& path, std::string_view label);

/// The bytes of an image file in base64, for a page that embeds its pictures.
std::string base64(std::string_view bytes);

}  // namespace lumaknot
