#include "exporters/obj/format.h"

namespace lumaknot {

extern const MeshFormat kObjFormat{.endings = {".obj"},
                                   .read = read_whole<read_obj>,
                                   .write = write_whole<write_obj>,
                                   .has_text = true,
                                   .has_quads = true};

}  // namespace lumaknot
