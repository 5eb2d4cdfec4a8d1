/// The shader that `lumaknot shader` emits.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "scene/spec.h"
#include "shaders/languages/emit.h"

namespace lumaknot::cli {

/// A formula of formula_names(), and how it is lit.
struct NamedFormula {
  std::string shader, rate = "pixel", gamut = "free";
  std::vector<std::string> lights;  ///< kinds; empty: one point light
  bool gated = false;
};

std::vector<Argument> formula_arguments(NamedFormula& formula);

/// The formula's shader. Throws Error if there is no such formula.
ShaderJob job_of_formula(const NamedFormula& formula);

/// A scene's shader, named after its file, with only what the scene needs.
ShaderJob job_of_scene(const SceneSpec& spec, const std::string& source);

/// Throws Error, naming --name, unless `name` is valid in every language.
void check_shader_name(const std::string& name);

}  // namespace lumaknot::cli
