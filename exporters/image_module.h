/// The module that reads and writes image files, loaded when it is first asked for.
#pragma once

#include "exporters/images/codec.h"

namespace lumaknot {

/// The functions of liblumaknot-images.so, which lies beside the program or one folder above it, as
/// for test programs. It stays loaded. Throws Error when it is not there or does not load.
const ImageCodec& image_codec();

}  // namespace lumaknot
