#include <nlohmann/json.hpp>

#include "shaders/blender_nodes.h"
#include "shaders/emit_parts.h"

namespace lumaknot {

std::vector<EmittedFile> emit_blender(const Shader& shader) {
  using Json = nlohmann::ordered_json;
  Json inputs = Json::array();
  for (const ShaderFunction::Input& input : color_function(shader).inputs) {
    inputs.push_back({{"name", input.name}, {"type", "vector"}});
  }
  for (const ShaderParameter& p : shader.fragment.parameters) {
    const ParameterRange range = range_of(p);
    Json entry{{"name", p.name}, {"type", p.is_vector ? "vector" : "float"}};
    entry["default"] = p.is_vector ? Json(components(p.value)) : Json(p.value.x);
    entry["min"] = range.least;
    entry["max"] = range.most;
    entry["meaning"] = parameter_info(p.name).meaning;
    inputs.push_back(std::move(entry));
  }
  Json recipe{{"name", shader.name}, {"inputs", inputs}};
  recipe.update(blender_nodes(shader.recorded.color, ParameterNodes::kInputs));
  recipe["output_name"] = "color";
  return {{shader.name + ".nodes.json", recipe.dump(1) + "\n"}};
}

}  // namespace lumaknot
