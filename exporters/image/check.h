/// Whether a file has the structure of a whole image: found in microseconds, where an image library
/// takes 200 ms to load and then accepts some truncated files.
#pragma once

#include <string_view>

namespace lumaknot {

/// Throws std::runtime_error naming the byte when `bytes` do not begin as a supported kind of
/// image, or when a PNG, JPEG, TIFF or OpenEXR file is cut short. Does not check pixels, and for
/// other formats nothing further.
void check_image_bytes(std::string_view bytes);

}  // namespace lumaknot
