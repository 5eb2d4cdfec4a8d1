#include "exporters/off/format.h"

namespace lumaknot {

extern const MeshFormat kOffFormat{.endings = {".off"},
                                   .read = read_whole<off::read>,
                                   .write = write_whole<off::write>,
                                   .has_text = true,
                                   .has_quads = true};

}  // namespace lumaknot
