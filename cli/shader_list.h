/// What shaders there are, and which language can express which.
#pragma once

#include <string>

namespace lumaknot {

/// A table: every shader, its operations, and a column for each language.
std::string shader_list_text();

/// The same as JSON: an entry for every shader and rate, with the languages that can express it and
/// why the others can't.
std::string shader_list_json();

}  // namespace lumaknot
