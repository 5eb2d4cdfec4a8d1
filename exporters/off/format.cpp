#include "exporters/off/format.h"

namespace lumaknot {

extern const MeshFormat kOffFormat{.endings = {".off"},
                                   .read = read_whole<read_off>,
                                   .write = write_whole<write_off>,
                                   .has_text = true,
                                   .has_quads = true};

}  // namespace lumaknot
