/// scene.json: reading, writing, and its published schema.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace lumaknot {

/// The scene that `text` describes; keys left out keep their defaults. Throws Error naming
/// `source` when the text is not JSON, and the JSON path when a key is unknown, a type is wrong or
/// a value is out of range. File names are returned as written.
SceneSpec scene_from_json(std::string_view text, std::string_view source);

/// The knot whose fields the JSON object `text` gives; what it leaves out is as knot_defaults() of
/// its convention has it. Throws Error as scene_from_json(), calling fields by field_label(prefix,
/// key).
KnotSpec knot_from_json(const nlohmann::ordered_json& json, const std::string& prefix);

/// The scene as JSON, every field written, ending in a newline. Read back it is the same scene.
std::string scene_to_json(const SceneSpec& spec);

/// The JSON Schema (draft 2020-12) of scene.json, ending in a newline.
std::string scene_json_schema();

}  // namespace lumaknot
