/// A glTF file's JSON, checked value by value as it is parsed: nothing is kept of what meshes do
/// not need, and a wrong value is refused before the rest is read. Inside exporters only.
#pragma once

#include <string>
#include <string_view>

#include "exporters/gltf_model.h"

namespace lumaknot {

/// Throws Error: "NAME: PLACE PROBLEM".
[[noreturn]] void fail_gltf(std::string_view name, std::string_view place,
                            std::string_view problem);

/// What a text of the file is, as a message quotes it: short, one line, nothing but ASCII.
std::string quoted_gltf(std::string_view text);

/// What the JSON says. Throws Error naming the JSON path of a value that is missing, there twice or
/// of the wrong type.
GltfModel gltf_model(std::string_view json, std::string_view name);

}  // namespace lumaknot
