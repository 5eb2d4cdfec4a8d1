#include "exporters/stl/format.h"

namespace lumaknot {

extern const MeshFormat kStlFormat{.endings = {".stl"},
                                   .read = read_whole<stl::read>,
                                   .write = write_whole<stl::write>,
                                   .has_text = true,
                                   .has_binary = true};

}  // namespace lumaknot
