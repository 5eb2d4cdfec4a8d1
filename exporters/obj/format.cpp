#include "exporters/obj/format.h"

namespace lumaknot {

extern const MeshFormat kObjFormat{.endings = {".obj"},
                                   .read = read_whole<obj::read>,
                                   .write = write_whole<obj::write>,
                                   .has_text = true,
                                   .has_quads = true};

}  // namespace lumaknot
