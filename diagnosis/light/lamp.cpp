/// A lamp that is elsewhere, brighter, coloured or missing.
#include <fmt/format.h>

#include "diagnosis/cause.h"
#include "math/angle.h"

namespace lumaknot::diagnosis {

namespace {

std::string called(const Situation& situation, std::size_t i) {
  return situation.setup.view.lights.size() > 1 ? fmt::format("light {}", i + 1) : "the light";
}

std::string id_of(const std::string& what, const Situation& situation, std::size_t i) {
  return situation.setup.view.lights.size() > 1 ? fmt::format("light-{}-{}", i + 1, what)
                                                : "light-" + what;
}

Hypothesis position(const Situation& situation, std::size_t i) {
  Light light = situation.setup.view.lights[i];
  const Vec3d own = *position_of(light);
  const double step = 0.01 * length(own - situation.centre) + 1e-9;
  Hypothesis h{.id = id_of("position", situation, i),
               .rung = Rung::kLight,
               .parameters = {{"x", own.x, step}, {"y", own.y, step}, {"z", own.z, step}},
               .apply =
                   [i](Setup& s, std::span<const double> p) {
                     *position_of(s.view.lights[i]) = {p[0], p[1], p[2]};
                   },
               .sentence =
                   [own, name = called(situation, i)](std::span<const double> p) {
                     return fmt::format("{} at {}, not {}", name, point({p[0], p[1], p[2]}),
                                        point(own));
                   }};
  const Vec3d eye = situation.setup.view.camera.position;
  h.starts = {{own.x, own.y, own.z},
              {-own.x, own.y, own.z},
              {own.x, -own.y, own.z},
              {own.x, own.y, -own.z},
              {eye.x, eye.y, eye.z}};
  return h;
}

Hypothesis intensity(const Situation& situation, std::size_t i) {
  return continuous(id_of("intensity", situation, i), Rung::kLight, {"factor", 1, 0.02, 0, 1e6},
                    called(situation, i) + " {:.4g} times as bright", [i](Setup& s, double factor) {
                      color_of(s.view.lights[i]).intensity *= factor;
                    });
}

Hypothesis times(const Situation& situation, std::size_t i, const std::string& id,
                 const std::string& what, double factor) {
  Hypothesis h =
      discrete(id_of(id, situation, i), Rung::kLight, called(situation, i) + what,
               [i, factor](Setup& s) { color_of(s.view.lights[i]).intensity *= factor; });
  h.special = true;
  return h;
}

Hypothesis color(const Situation& situation, std::size_t i) {
  Light light = situation.setup.view.lights[i];
  const Vec3d own = color_of(light).rgb;
  return {.id = id_of("color", situation, i),
          .rung = Rung::kLight,
          .parameters = {{"r", own.x, 0.02, 0, 100},
                         {"g", own.y, 0.02, 0, 100},
                         {"b", own.z, 0.02, 0, 100}},
          .apply =
              [i](Setup& s, std::span<const double> p) {
                color_of(s.view.lights[i]).rgb = {p[0], p[1], p[2]};
              },
          .sentence =
              [own, name = called(situation, i)](std::span<const double> p) {
                return fmt::format("{} coloured {}, not {}", name, point({p[0], p[1], p[2]}),
                                   point(own));
              }};
}

/// The light's direction, of lights that have no position.
Hypothesis direction(const Situation& situation, std::size_t i) {
  const Vec3d own = normalize(std::get<DirectionalLight>(situation.setup.view.lights[i]).direction);
  return {.id = id_of("direction", situation, i),
          .rung = Rung::kLight,
          .parameters = {{"x", own.x, 0.01}, {"y", own.y, 0.01}, {"z", own.z, 0.01}},
          .apply =
              [i](Setup& s, std::span<const double> p) {
                const Vec3d d{p[0], p[1], p[2]};
                if (length(d) > 0) std::get<DirectionalLight>(s.view.lights[i]).direction = d;
              },
          .sentence =
              [own, name = called(situation, i)](std::span<const double> p) {
                return fmt::format("{} shining along {}, not {}", name,
                                   point(normalize(Vec3d{p[0], p[1], p[2]})), point(own));
              },
          .starts = {{own.x, own.y, own.z}, {-own.x, -own.y, -own.z}}};
}

}  // namespace

std::vector<Hypothesis> lamp(const Situation& situation) {
  std::vector<Hypothesis> all;
  for (std::size_t i = 0; i < situation.setup.view.lights.size(); ++i) {
    Light light = situation.setup.view.lights[i];
    all.push_back(position_of(light) ? position(situation, i) : direction(situation, i));
    all.push_back(intensity(situation, i));
    all.push_back(times(situation, i, "by-pi", " divided by pi", 1 / kPi));
    all.push_back(times(situation, i, "times-pi", " multiplied by pi", kPi));
    all.push_back(times(situation, i, "missing", " missing", 0));
    if (situation.setup.view.material.space == Space::kRgb) all.push_back(color(situation, i));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
