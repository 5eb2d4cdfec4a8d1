#include "tests/kernel/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "scene/fields.h"
#include "scene/presets.h"

namespace lumaknot::testing {
namespace {

struct Variant {
  std::string name;
  std::function<void(ShaderJob&)> apply;
};

const std::vector<Variant>& variants() {
  static const std::vector<Variant> kVariants{
      {"gamut clamp", [](ShaderJob& job) { job.shot.material.gamut = Gamut::kClamp; }},
      {"gamut chroma", [](ShaderJob& job) { job.shot.material.gamut = Gamut::kChroma; }},
      {"gated", [](ShaderJob& job) { job.shot.material.highlights = Highlights::kGated; }},
      {"no light", [](ShaderJob& job) { job.view.lights = {}; }},
      {"directional", [](ShaderJob& job) { job.view.lights = {DirectionalLight{}}; }},
      {"spot", [](ShaderJob& job) { job.view.lights = {SpotLight{}}; }},
      {"three lights",
       [](ShaderJob& job) { job.view.lights = {PointLight{}, DirectionalLight{}, SpotLight{}}; }},
      {"as the scene needs", [](ShaderJob& job) { job.keep = Keep::kNeeded; }},
      {"plain colour", [](ShaderJob& job) { job.color = Vec3d{0.7, 0.5, 0.25}; }},
  };
  return kVariants;
}

KernelCell cell(const std::string& formula, const std::string& variant) {
  KernelCell result{formula, variant, {}};
  result.job.name = formula;
  result.job.shot = {"final", Stage::kFinal, *with_formula(Material{}, formula)};
  result.job.keep = Keep::kAll;
  return result;
}

KernelCell vertex_cell(const std::string& formula) {
  KernelCell result = cell(formula, "vertex");
  result.job.shot.material.rate = ShadingFrequency::kVertex;
  return result;
}

}  // namespace

KernelCell plain_cell(const std::string& formula) { return cell(formula, "pixel"); }

std::vector<std::string> space_uses() {
  const std::string model = fmt::format("-{}", kModelNames[0]);
  std::vector<std::string> uses;
  for (const std::string& name : formula_names()) {
    if (!name.ends_with(model)) continue;
    const std::string use = name.substr(0, name.size() - model.size());
    if (!use.ends_with("-blinn")) uses.push_back(use);
  }
  return uses;
}

std::vector<KernelCell> cells_of(const std::string& space_use, bool vertex_stage) {
  const std::vector<std::string> uses = space_uses();
  const auto place = std::size_t(std::ranges::find(uses, space_use) - uses.begin());
  std::vector<std::string> formulas;
  for (const std::string_view model : kModelNames) {
    formulas.push_back(fmt::format("{}-{}", space_use, model));
  }
  std::vector<KernelCell> cells;
  for (const std::string& formula : formulas) {
    cells.push_back(plain_cell(formula));
    if (vertex_stage) cells.push_back(vertex_cell(formula));
  }
  for (std::size_t i = 0; i < variants().size(); ++i) {
    cells.push_back(cell(formulas[(place + i) % formulas.size()], variants()[i].name));
    variants()[i].apply(cells.back().job);
  }
  return cells;
}

std::string cell_test_name(Language language, const std::string& space_use) {
  std::string name = fmt::format("{}_{}", backend_of(language).name, space_use);
  std::ranges::replace(name, '-', '_');
  return name;
}

}  // namespace lumaknot::testing
