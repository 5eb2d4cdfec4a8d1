#include "shaders/graph/parameters.h"

#include <cassert>
#include <cctype>
#include <string>

#include "models/registry.h"

namespace lumaknot {
namespace {

constexpr double kFar = 1000;  // scene units: the range of a slider for a position

constexpr ParameterInfo kParameters[] = {
    {"eye_position", -kFar, kFar, 0.1, "scene units", "the eye, world space", "CameraPosition"},
    {"light_position", -kFar, kFar, 0.1, "scene units", "the lamp, world space", "Position"},
    {"light_direction", -1, 1, 0.01, "unit vector", "in which the light shines, world space",
     "Direction"},
    {"light_color", 0, 100, 0.01, "of white",
     "colour times intensity; in a space of brightness the brightness of that colour", ""},
    {"light_constant", 0, 100, 0.01, "none",
     "of the falloff 1 / (constant + linear d + quadratic d^2)", ""},
    {"light_linear", 0, 100, 0.01, "1 / scene unit", "of the falloff, per distance", ""},
    {"light_quadratic", 0, 100, 0.01, "1 / scene unit^2", "of the falloff, per distance squared",
     ""},
    {"light_cos_outer", -1, 1, 0.01, "cosine", "of the angle beyond which the cone is dark", ""},
    {"light_cone_scale", 0.5, 1e6, 1, "1 / cosine", "1 / (cos inner - cos outer) of the cone", ""},
    {"ambient", 0, 1, 0.1, "of white", "ambient light times its weight, L_A", ""},
    {"diffuse", 0, 1, 0.01, "of white", "weight of the diffuse term L_D", ""},
    {"specular", 0, 1, 0.01, "of white", "weight of the specular term L_S", ""},
    {"emissive", 0, 1, 0.01, "of white", "what the surface sends out by itself", ""},
    {"luma_offset", -1, 1, 0.01, "of white", "added to the lit brightness; Table 1: -0.1", ""},
    {"base_color", 0, 1, 0.01, "r'g'b'", "the surface's colour", "Diffuse"},
    {"base_axes", -1, 1, 0.01, "axes of the space", "the surface's colour: brightness and chroma",
     ""},
    {"world", -kFar, kFar, 0.1, "matrix", "from the mesh's space to the world's", "World"},
    {"world_inverse_transpose", -kFar, kFar, 0.1, "matrix", "of `world`, for normals",
     "WorldInverseTranspose"},
    {"world_view_projection", -kFar, kFar, 0.1, "matrix",
     "from the mesh's space to the clip space of the interface", "WorldViewProjection"},
    {"color_texture", 0, 1, 0.01, "image",
     "the surface's colour, r'g'b' as it is in the file: no sRGB decoding", "Diffuse"},
    {"axes_texture", -1, 1, 0.01, "image",
     "the surface's colour on the axes of the space, float: brightness, then the two of chroma",
     ""},
};

/// Maps light2_position to light_position.
std::string without_number(std::string_view name) {
  constexpr std::string_view kLight = "light";
  if (!name.starts_with(kLight)) return std::string(name);
  std::size_t end = kLight.size();
  while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end]))) ++end;
  return std::string(kLight) + std::string(name.substr(end));
}

}  // namespace

ParameterInfo parameter_info(std::string_view name) {
  for (const Parameter& p : model_parameters()) {
    if (p.name == name) {
      return {p.name, p.slider.min, p.slider.max, p.step, p.unit, p.meaning, p.semantic};
    }
  }
  const std::string plain = without_number(name);
  for (const ParameterInfo& info : kParameters) {
    if (info.name == plain) return info;
  }
  assert(false && "every number that lighting_of() names is in the table");
  return kParameters[0];
}

}  // namespace lumaknot
