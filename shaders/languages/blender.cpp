#include <nlohmann/json.hpp>

#include "shaders/graph/blender_nodes.h"
#include "shaders/languages/common.h"

namespace lumaknot::nodes {
namespace {

/// Nodes have sockets by the formula's own names; nothing is printed.
constexpr Dialect kDialect{};

std::vector<EmittedFile> emit(const Shader& shader) {
  using Json = nlohmann::ordered_json;
  Json inputs = Json::array();
  for (const ShaderFunction::Input& input : color_function(shader).inputs) {
    inputs.push_back({{"name", input.name}, {"type", "vector"}});
  }
  for (const ShaderParameter& p : shader.fragment.parameters) {
    const Interval<double> range = range_of(p);
    Json entry{{"name", p.name}, {"type", p.is_vector ? "vector" : "float"}};
    entry["default"] = p.is_vector ? Json(components(p.value)) : Json(p.value.x);
    entry["min"] = range.min;
    entry["max"] = range.max;
    entry["meaning"] = parameter_info(p.name).meaning;
    inputs.push_back(std::move(entry));
  }
  Json recipe{{"name", shader.name}, {"inputs", inputs}};
  recipe.update(blender_nodes(shader.recorded.color, ParameterNodes::kInputs));
  recipe["output_name"] = "color";
  return {{shader.name + ".nodes.json", recipe.dump(1) + "\n"}};
}

}  // namespace
}  // namespace lumaknot::nodes

namespace lumaknot {

extern const Backend kBlenderBackend{.name = "blender",
                                     .about = "Blender 3.4 to 5.x, a node group",
                                     .dialect = &nodes::kDialect,
                                     .emit = nodes::emit};

}  // namespace lumaknot
