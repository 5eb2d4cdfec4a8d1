/// Shaders as include files for POV-Ray 3.7.
///
/// POV-Ray's lighting is fixed, but its scene language computes while a scene is read. So a shader
/// becomes a macro of that language, in double: for lit colours at the corners of a mesh, or to
/// compare with what POV-Ray's own lighting draws.
#pragma once

#include <optional>
#include <string>

#include "shaders/code_printer.h"
#include "shaders/shader.h"

namespace lumaknot {

extern const Dialect kPovDialect;

/// A macro of POV-Ray 3.7 has no more parameters than these.
inline constexpr std::size_t kMostPovParameters = 55;

/// Says so when the macro of `shader` would have more.
std::optional<std::string> pov_shortfall(const Shader& shader);

/// An include file with one macro that computes the colour of `shader`, whose light is computed a
/// pixel. Its parameters are the surface's values, then the shader's. Throws Error when they are
/// more than kMostPovParameters.
std::string emit_pov(const Shader& shader);

}  // namespace lumaknot
