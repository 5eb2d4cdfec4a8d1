/// What `lumaknot shader` is asked to emit.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "scene/scene.h"
#include "shaders/emit.h"

namespace lumaknot {

/// A formula of formula_names(), and how it is to be lit.
struct NamedFormula {
  std::string shader, rate = "pixel", gamut = "free";
  std::vector<std::string> lights;  ///< kinds; empty: one point light
  bool gated = false;
};

std::vector<Argument> formula_arguments(NamedFormula& formula);

/// The formula's shader. Throws Error when there is no such formula.
ShaderJob job_of_formula(const NamedFormula& formula);

/// A scene's shader, called as its file: only what the scene needs.
ShaderJob job_of_scene(const SceneSpec& spec, const std::string& source);

/// Throws Error, naming --name, unless every language takes `name`.
void check_shader_name(const std::string& name);

}  // namespace lumaknot
