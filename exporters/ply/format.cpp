#include "exporters/ply/format.h"

namespace lumaknot {

extern const MeshFormat kPlyFormat{.endings = {".ply"},
                                   .read = read_whole<ply::read>,
                                   .write = write_whole<ply::write>,
                                   .has_text = true,
                                   .has_binary = true,
                                   .has_quads = true};

}  // namespace lumaknot
