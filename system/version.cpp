#include "system/version.h"

namespace lumaknot {

std::string_view version() { return LUMAKNOT_VERSION; }

}  // namespace lumaknot
