// What POV-Ray 3.7 can't draw. Its lighting is fixed, see scene.h.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "exporters/povray/lights.h"
#include "exporters/povray/scene.h"
#include "exporters/povray/texture.h"
#include "scene/fields.h"
#include "shaders/formulas/lighting.h"
#include "system/error.h"
#include "system/listing.h"

namespace lumaknot::povray {
namespace {

/// Something that POV-Ray can't do.
struct Shortfall {
  std::string what;     ///< after "POV-Ray can't"
  std::string nearest;  ///< what it can do; empty: it draws without it
};
using Shortfalls = std::vector<Shortfall>;

void add(Shortfalls& list, bool lacks, std::string what, std::string nearest = {}) {
  if (lacks) list.push_back({std::move(what), std::move(nearest)});
}

/// "POV-Ray can't A, B nor C", or empty.
std::optional<std::string> sentence(const Shortfalls& list) {
  if (list.empty()) return std::nullopt;
  std::vector<std::string> lacks;
  lacks.reserve(list.size());
  for (const Shortfall& s : list) lacks.push_back(s.what);
  return "POV-Ray can't " + listing(lacks, "nor");
}

/// The sentence, then the nearest of each.
std::optional<std::string> with_nearest(const Shortfalls& list) {
  std::vector<std::string_view> nearest;
  for (const Shortfall& s : list) nearest.push_back(s.nearest);
  auto text = sentence(list);
  if (!text) return text;
  return fmt::format("{}; nearest: {}", *text, fmt::join(nearest, ", "));
}

/// Lists a light's properties that POV-Ray does not support.
class LightShortfalls {
 public:
  explicit LightShortfalls(std::size_t index) : index_(index) {}

  Shortfalls operator()(const PointLight& light) const { return falloff("point", light.falloff); }
  Shortfalls operator()(const DirectionalLight&) const { return {}; }
  Shortfalls operator()(const SpotLight& light) const {
    Shortfalls list = falloff("spot", light.falloff);
    add(list, light.outer_degrees > kPovWidestSpot,
        "shine a spot further than 90 degrees off its axis",
        fmt::format("lights[{}].spot.outer_degrees {}", index_, kPovWidestSpot));
    return list;
  }

 private:
  Shortfalls falloff(std::string_view kind, const Falloff& falloff) const {
    Shortfalls list;
    add(list, !has_pov_falloff(falloff), "weaken a light linearly and quadratically at once",
        fmt::format("lights[{}].{}.linear 0 or quadratic 0", index_, kind));
    return list;
  }
  std::size_t index_;
};

void add(Shortfalls& list, const PovTerm& term) {
  add(list, !term.lack.empty(), std::string(term.lack), std::string(term.nearest));
}

/// A light that can't be drawn at all.
Shortfalls missing_terms(const View& view, const Shot& shot) {
  const bool diffuse = needs_diffuse(view, shot), specular = needs_specular(view, shot);
  Shortfalls list;
  if (!diffuse && !specular) return list;
  if (diffuse) add(list, diffuse_in_pov(shot.material));
  if (specular) add(list, highlight_in_pov(shot.material));
  for (std::size_t i = 0; i < view.lights.size(); ++i) {
    const Shortfalls of_light = std::visit(LightShortfalls(i), view.lights[i]);
    list.insert(list.end(), of_light.begin(), of_light.end());
  }
  add(list, shot.material.rate == ShadingFrequency::kVertex, "compute light per vertex",
      "material.rate \"pixel\"");
  return list;
}

/// What turns the final picture into another formula, though its terms can be drawn.
Shortfalls missing_formula(const View& view, const Shot& shot) {
  Shortfalls list;
  if (shot.stage != Stage::kFinal) return list;
  const Space space = shot.material.space;
  const bool linear = space == Space::kRgb || is_linear(space);
  add(list, !linear,
      fmt::format("light the brightness of {} alone", kSpaceNames[std::size_t(space)]),
      "material.space \"yiq\"");
  add(list, linear && space == Space::kRgb && !pov_highlight(view, shot),
      "leave a channel without highlights that has a diffuse term",
      "material.specular_color without a 0");
  return list;
}

/// What is left out.
Shortfalls left_out(const Shot& shot) {
  const Material& m = shot.material;
  Shortfalls list;
  if (shot.stage != Stage::kFinal) return list;
  add(list, m.clamp == Clamp::kTable1, "clamp ambient plus diffuse light");
  add(list, m.normal == NormalUse::kInterpolated,
      "use an interpolated normal without renormalising it");
  add(list, m.gamut == Gamut::kChroma, "keep the hue of colours beyond [0, 1]");
  return list;
}

Shortfalls joined(Shortfalls list, const Shortfalls& more) {
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

}  // namespace

bool needs_diffuse(const View& view, const Shot& shot) {
  if (shot.stage != Stage::kFinal) return shot.stage == Stage::kDiffuse;
  return lighting_of<double>(view, shot.material).diffuse != Vec3d{} && !view.lights.empty();
}

bool needs_specular(const View& view, const Shot& shot) {
  if (shot.stage != Stage::kFinal) return shot.stage == Stage::kSpecular;
  return lighting_of<double>(view, shot.material).specular != Vec3d{} && !view.lights.empty();
}

std::optional<std::string> pov_shortfall(const View& view, const Shot& shot) {
  return sentence(
      joined(joined(missing_terms(view, shot), missing_formula(view, shot)), left_out(shot)));
}

std::optional<std::string> pov_missing_term(const View& view, const Shot& shot) {
  return with_nearest(missing_terms(view, shot));
}

void check_pov_export(const View& view, const Shot& shot) {
  const auto lack = with_nearest(joined(missing_terms(view, shot), missing_formula(view, shot)));
  if (lack) throw Error(*lack);
}

}  // namespace lumaknot::povray
