/// Lists in sentences.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lumaknot {

/// "a, b or c": `items` with the `conjunction` before the last one.
std::string listing(const std::vector<std::string>& items, std::string_view conjunction);

}  // namespace lumaknot
