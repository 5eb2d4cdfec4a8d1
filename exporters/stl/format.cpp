#include "exporters/stl/format.h"

namespace lumaknot {

extern const MeshFormat kStlFormat{.endings = {".stl"},
                                   .read = read_whole<read_stl>,
                                   .write = write_whole<write_stl>,
                                   .has_text = true,
                                   .has_binary = true};

}  // namespace lumaknot
