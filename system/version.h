/// The program's version.
#pragma once

#include <string_view>

namespace lumaknot {

/// "0.1.0", as in CMakeLists.txt.
std::string_view version();

}  // namespace lumaknot
