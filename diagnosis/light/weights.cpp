/// Other weights of the ambient, diffuse and specular light.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

namespace {

Hypothesis factor(const std::string& id, const std::string& format, void (*scale)(Setup&, double)) {
  return continuous(id, Rung::kLight, {"factor", 1, 0.02, 0, 1e6}, format, scale);
}

Hypothesis none(const std::string& id, const std::string& sentence, void (*scale)(Setup&, double)) {
  Hypothesis h = discrete(id, Rung::kLight, sentence, [scale](Setup& s) { scale(s, 0); });
  h.special = true;
  return h;
}

void ambient(Setup& s, double by) { s.view.ambient *= by; }
void diffuse(Setup& s, double by) { s.view.material.diffuse *= by; }
void specular(Setup& s, double by) { s.view.material.specular *= by; }
void all_light(Setup& s, double by) {
  ambient(s, by);
  diffuse(s, by);
  specular(s, by);
}

/// A colour that the material's weight is multiplied by.
Hypothesis tint(const std::string& id, const std::string& what, Vec3d Material::* color,
                const Vec3d& own) {
  return {
      .id = id,
      .rung = Rung::kLight,
      .parameters = {{"r", own.x, 0.02, 0, 100},
                     {"g", own.y, 0.02, 0, 100},
                     {"b", own.z, 0.02, 0, 100}},
      .apply = [color](Setup& s,
                       std::span<const double> p) { s.view.material.*color = {p[0], p[1], p[2]}; },
      .sentence =
          [what, own](std::span<const double> p) {
            return fmt::format("{} coloured {}, not {}", what, point({p[0], p[1], p[2]}),
                               point(own));
          }};
}

}  // namespace

std::vector<Hypothesis> weights(const Situation& situation) {
  const View& view = situation.setup.view;
  const double own = view.ambient;
  std::vector<Hypothesis> all{continuous("ambient", Rung::kLight, {"ambient", own, 0.01, 0, 1e6},
                                         "ambient light {:.4g}, not " + number(own),
                                         [](Setup& s, double value) { s.view.ambient = value; }),
                              none("ambient-none", "no ambient light", ambient),
                              factor("diffuse", "diffuse light times {:.4g}", diffuse),
                              none("diffuse-none", "no diffuse light", diffuse),
                              factor("specular", "highlights {:.4g} times as bright", specular),
                              none("specular-none", "no highlights", specular),
                              factor("all-light", "all light {:.4g} times as bright", all_light)};
  if (view.material.space != Space::kRgb) return all;
  const Material& m = view.material;
  all.push_back(tint("ambient-color", "ambient light", &Material::ambient_color, m.ambient_color));
  all.push_back(tint("diffuse-color", "diffuse light", &Material::diffuse_color, m.diffuse_color));
  all.push_back(tint("specular-color", "highlights", &Material::specular_color, m.specular_color));
  all.push_back(tint("emissive", "emitted light", &Material::emissive, m.emissive));
  return all;
}

}  // namespace lumaknot::diagnosis
