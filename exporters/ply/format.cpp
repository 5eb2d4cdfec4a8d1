#include "exporters/ply/format.h"

namespace lumaknot {

extern const MeshFormat kPlyFormat{.endings = {".ply"},
                                   .read = read_whole<read_ply>,
                                   .write = write_whole<write_ply>,
                                   .has_text = true,
                                   .has_binary = true,
                                   .has_quads = true};

}  // namespace lumaknot
