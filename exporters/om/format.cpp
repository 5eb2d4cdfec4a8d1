#include "exporters/om/format.h"

namespace lumaknot {

extern const MeshFormat kOmFormat{.endings = {".om"},
                                  .read = read_whole<read_om>,
                                  .write = write_whole<write_om>,
                                  .has_binary = true};

}  // namespace lumaknot
