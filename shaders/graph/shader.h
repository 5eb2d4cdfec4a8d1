/// A shader before it is printed: the recorded formula and what its stages read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shaders/graph/record.h"

namespace lumaknot {

/// What to emit.
struct ShaderJob {
  std::string name;  ///< lower case, digits and '-': names the files, and with '_' the function
  View view;
  Shot shot;
  Keep keep = Keep::kNeeded;
  std::optional<Vec3d> color;  ///< r'g'b' of a surface without a texture
};

/// A number that a stage reads.
struct ShaderParameter {
  std::string name;
  bool is_vector = false;
  Vec3d value;  ///< now; a scalar in x
};

/// What one stage reads.
struct StageReads {
  bool position = false, normal = false, texture = false;
  std::vector<ShaderParameter> parameters;  ///< vectors first, then scalars
};

/// The formula of a job and what its stages read.
struct Shader {
  std::string name;      ///< yiq-phong
  std::string function;  ///< yiq_phong
  Recorded recorded;
  bool baked = false;                       ///< the texture holds the axes of the space
  StageReads vertex, fragment;              ///< vertex: of the varyings
  std::vector<ShaderParameter> parameters;  ///< of both, vectors first, then scalars

  bool textured() const { return fragment.texture; }
};

Shader make_shader(const ShaderJob& job);

}  // namespace lumaknot
