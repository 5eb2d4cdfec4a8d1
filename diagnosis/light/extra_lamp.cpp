/// A lamp too many: at the camera, or anywhere.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> extra_lamp(const Situation& situation) {
  const Vec3d eye = situation.setup.view.camera.position;
  Hypothesis headlight = continuous(
      "headlight", Rung::kLight, {"intensity", 0, 0.02, 0, 1e6},
      "another light at the camera, intensity {:.4g}", [eye](Setup& s, double intensity) {
        s.view.lights.emplace_back(PointLight{eye, {{1, 1, 1}, intensity}, {}});
      });
  const double step = 0.02 * length(eye - situation.centre);
  const Vec3d c = situation.centre;
  const double r = length(eye - c);
  Hypothesis extra{
      .id = "extra-light",
      .rung = Rung::kLight,
      .parameters = {{"x", eye.x, step},
                     {"y", eye.y, step},
                     {"z", eye.z, step},
                     {"intensity", 0.3, 0.02, 0, 1e6}},
      .apply =
          [](Setup& s, std::span<const double> p) {
            s.view.lights.emplace_back(PointLight{{p[0], p[1], p[2]}, {{1, 1, 1}, p[3]}, {}});
          },
      .sentence =
          [](std::span<const double> p) {
            return fmt::format("another light at {}, intensity {}", point({p[0], p[1], p[2]}),
                               number(p[3]));
          },
      .starts = {{eye.x, eye.y, eye.z, 0.3},
                 {c.x + r, c.y, c.z + r, 0.3},
                 {c.x - r, c.y, c.z + r, 0.3},
                 {c.x, c.y + r, c.z, 0.3},
                 {c.x, c.y - r, c.z + r, 0.3},
                 {c.x, c.y, c.z - r, 0.3}}};
  return {headlight, extra};
}

}  // namespace lumaknot::diagnosis
