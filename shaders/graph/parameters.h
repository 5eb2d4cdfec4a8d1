/// User documentation of the scene's numbers that shaders read.
#pragma once

#include <string_view>

namespace lumaknot {

/// A parameter as described in parameters.json and in the annotations of effects.
struct ParameterInfo {
  std::string_view name;  ///< without a light's number: light_position for light2_position too
  double min, max, step;  ///< of a slider; for every component of a vector
  std::string_view unit;
  std::string_view meaning;
  std::string_view semantic;  ///< its name in the Standard Annotations and Semantics, or empty
};

/// The entry of the parameter `name`.
ParameterInfo parameter_info(std::string_view name);

}  // namespace lumaknot
