#include "exporters/om/format.h"

namespace lumaknot {

extern const MeshFormat kOmFormat{.endings = {".om"},
                                  .read = read_whole<om::read>,
                                  .write = write_whole<om::write>,
                                  .has_binary = true};

}  // namespace lumaknot
