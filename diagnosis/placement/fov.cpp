/// Another field of view.
#include <fmt/format.h>

#include <cmath>

#include "diagnosis/cause.h"
#include "math/angle.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> fov(const Situation& situation) {
  const View& view = situation.setup.view;
  const double own = view.camera.fov_degrees;
  std::vector<Hypothesis> all{
      {.id = "fov",
       .rung = Rung::kPlacement,
       .parameters = {{"fov_degrees", own, 0.01 * own, 0.1, 179}},
       .apply = [](Setup& s, std::span<const double> p) { s.view.camera.fov_degrees = p[0]; },
       .sentence =
           [own](std::span<const double> p) {
             const double change = std::tan(p[0] * kPi / 360) / std::tan(own * kPi / 360);
             return fmt::format("a field of view of {} degrees, not {} ({:.3g} % {})", number(p[0]),
                                number(own), 100 * std::abs(change - 1),
                                change > 1 ? "wider" : "narrower");
           },
       .starts = {{own},
                  {0.8 * own},
                  {std::min(1.25 * own, 170.0)},
                  {0.5 * own},
                  {std::min(2 * own, 170.0)}}}};
  if (view.image.width == view.image.height) return all;
  const double aspect = double(view.image.width) / view.image.height;
  all.push_back(discrete("fov-horizontal", Rung::kPlacement,
                         "its field of view taken as the horizontal one", [aspect](Setup& s) {
                           double& degrees = s.view.camera.fov_degrees;
                           degrees =
                               2 * kDegrees * std::atan(std::tan(degrees * kPi / 360) / aspect);
                         }));
  all.back().special = true;
  return all;
}

}  // namespace lumaknot::diagnosis
