/// scene.json: reading, writing, and its published schema.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "scene/spec.h"

namespace lumaknot {

/// The scene that `text` describes; keys left out keep their defaults. Throws Error naming
/// `source` when the text is not JSON, and the JSON path when a key is unknown, a type is wrong or
/// a value is out of range. File names are returned as written.
SceneSpec scene_from_json(std::string_view text, std::string_view source);

/// The knot whose fields the JSON object `text` gives; missing fields are those of knot_defaults()
/// of its convention. Throws Error as scene_from_json() does, naming fields by field_label(prefix,
/// key).
KnotSpec knot_from_json(const nlohmann::ordered_json& json, const std::string& prefix);

/// The scene as JSON, every field written, ending in a newline. Reading it back gives the same
/// scene.
std::string scene_to_json(const SceneSpec& spec);

/// The JSON Schema (draft 2020-12) of scene.json, ending in a newline.
std::string scene_json_schema();

}  // namespace lumaknot
