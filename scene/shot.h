/// A stage of a scene, drawn with a material.
#pragma once

#include <string>

#include "scene/spec.h"

namespace lumaknot {

/// How much of the lighting formula a picture shows. Each stage needs the previous ones, so that
/// the first that differs between two renderers identifies the cause.
enum class Stage {
  kTexture,   ///< T, the surface's own colour
  kDiffuse,   ///< L_D alone, as a grey
  kSpecular,  ///< L_S alone, as a grey
  kFinal      ///< the lit colour
};

/// One picture of a scene: a stage, drawn with a material that replaces the scene's.
struct Shot {
  std::string name;  ///< letters, digits and '-'; unique within a job
  Stage stage = Stage::kFinal;
  Material material;
};

}  // namespace lumaknot
