/// Whether a file's frame is that of a whole image: told in microseconds, where an image library is
/// loaded in 200 ms and then takes some cut files for whole ones. Inside exporters only.
#pragma once

#include <string_view>

namespace lumaknot {

/// Throws std::runtime_error naming the byte where `bytes` begin as no kind of image that is read,
/// or where a PNG, JPEG, TIFF or OpenEXR file is cut short. Looks at no pixel, and no further into
/// others.
void check_image_bytes(std::string_view bytes);

}  // namespace lumaknot
