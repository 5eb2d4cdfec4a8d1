/// A glTF file's JSON, checked value by value during parsing: only what meshes need is kept, and a
/// wrong value is refused before the rest is read.
#pragma once

#include <string>
#include <string_view>

#include "exporters/gltf/model.h"

namespace lumaknot::gltf {

/// Throws Error: "NAME: PLACE PROBLEM".
[[noreturn]] void fail_gltf(std::string_view name, std::string_view place,
                            std::string_view problem);

/// A text of the file as a message quotes it: short, on one line, ASCII only.
std::string quoted_gltf(std::string_view text);

/// The model that the JSON describes. Throws Error naming the JSON path of a value that is missing,
/// appears twice or has the wrong type.
GltfModel gltf_model(std::string_view json, std::string_view name);

}  // namespace lumaknot::gltf
