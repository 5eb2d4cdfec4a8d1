#include "exporters/povray/format.h"

namespace lumaknot {

extern const MeshFormat kPovFormat{.endings = {".pov", ".inc"},
                                   .read = read_whole<povray::read_pov>};

extern const MeshFormat kPovIncludeFormat{.endings = {".inc"},
                                          .remark = "POV-Ray",
                                          .write = write_whole<povray::write_pov_include>,
                                          .has_text = true};

}  // namespace lumaknot
