/// The list of shaders and the languages that can express them.
#pragma once

#include <string>

namespace lumaknot::cli {

/// A table of every shader, its operations, and a column per language.
std::string shader_list_text();

/// The same as JSON: an entry per shader and rate, with the languages that can express it and why
/// the others can't.
std::string shader_list_json();

}  // namespace lumaknot::cli
