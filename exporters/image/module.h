/// The module that reads and writes image files, loaded on first use.
#pragma once

#include "exporters/image/module/codec.h"

namespace lumaknot {

/// The functions of liblumaknot-images.so, which is next to the program or, for test programs, one
/// folder above it. It stays loaded. Throws Error when it is missing or does not load.
const ImageCodec& image_codec();

}  // namespace lumaknot
