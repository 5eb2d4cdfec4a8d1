/// What we read of a glTF file's JSON, checked before a library gets it. Inside exporters only.
///
/// tinygltf takes members of the wrong type for missing ones, cuts integers to 32 bits, drops
/// primitives that it can't parse, and recurses as deep as `extras` are nested. What it gets from
/// here is nothing but members of the right type, and no deeper than they need to be.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace lumaknot {

/// Throws Error: "NAME: PLACE PROBLEM".
[[noreturn]] void fail_gltf(std::string_view name, std::string_view place,
                            std::string_view problem);

/// What a text of the file is, as a message quotes it: short, one line, nothing but ASCII.
std::string quoted_gltf(std::string_view text);

/// The members of the JSON that meshes need, without all else, each of the right type. Throws
/// Error naming the JSON path.
nlohmann::json gltf_outline(std::string_view json, std::string_view name);

}  // namespace lumaknot
