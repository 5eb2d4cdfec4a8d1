/// The camera stands elsewhere, looks elsewhere, or is rolled.
#include <fmt/format.h>

#include <cmath>

#include "diagnosis/cause.h"
#include "math/angle.h"

namespace lumaknot::diagnosis {

namespace {

Hypothesis at_point(std::string id, const std::string& what, const Vec3d& own, double step,
                    Vec3d Camera::* member) {
  return {
      .id = std::move(id),
      .rung = Rung::kPlacement,
      .parameters = {{"x", own.x, step}, {"y", own.y, step}, {"z", own.z, step}},
      .apply = [member](Setup& s,
                        std::span<const double> p) { s.view.camera.*member = {p[0], p[1], p[2]}; },
      .sentence =
          [what, own](std::span<const double> p) {
            return fmt::format("{} {}, not {}", what, point({p[0], p[1], p[2]}), point(own));
          }};
}

Hypothesis roll() {
  return continuous("camera-roll", Rung::kPlacement, {"degrees", 0, 0.5, -360, 360},
                    "the camera rolled by {:.4g} degrees", [](Setup& s, double degrees) {
                      const CameraFrame frame = camera_frame(s.view.camera);
                      const double a = degrees * kDegree;
                      s.view.camera.up = frame.up * std::cos(a) + frame.right * std::sin(a);
                    });
}

Hypothesis up(const std::string& axis, const Vec3d& direction) {
  return discrete("camera-up-" + axis, Rung::kPlacement, "the camera's up along " + axis,
                  [direction](Setup& s) { s.view.camera.up = direction; });
}

}  // namespace

std::vector<Hypothesis> camera(const Situation& situation) {
  const Camera& own = situation.setup.view.camera;
  const double step = 0.005 * length(own.position - own.target);
  Hypothesis rolled = roll();
  for (int degrees = -165; degrees <= 180; degrees += 15)
    rolled.starts.push_back({double(degrees)});
  std::vector<Hypothesis> all{
      at_point("camera-position", "the camera at", own.position, step, &Camera::position),
      at_point("camera-target", "the camera looking at", own.target, step, &Camera::target),
      rolled};
  const Vec3d sight = normalize(own.target - own.position);
  const auto add = [&](const std::string& axis, const Vec3d& direction) {
    if (std::abs(dot(direction, sight)) < 0.999 && length(cross(direction, own.up)) > 1e-6)
      all.push_back(up(axis, direction));
  };
  add("x", {1, 0, 0});
  add("y", {0, 1, 0});
  add("z", {0, 0, 1});
  return all;
}

}  // namespace lumaknot::diagnosis
