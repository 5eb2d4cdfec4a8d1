/// What the numbers of a scene that shaders read mean to a user.
#pragma once

#include <string_view>

namespace lumaknot {

/// A parameter as parameters.json and the annotations of effects tell it.
struct ParameterInfo {
  std::string_view name;     ///< without a light's number: light_position for light2_position too
  double least, most, step;  ///< of a slider; of every component of a vector
  std::string_view unit;
  std::string_view meaning;
  std::string_view semantic;  ///< as the Standard Annotations and Semantics name it, or empty
};

/// The entry of the parameter called `name`.
const ParameterInfo& parameter_info(std::string_view name);

}  // namespace lumaknot
