/// No texture.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> untextured(const Situation& situation) {
  const bool image = has_image(situation);
  const Vec3d own = image ? Vec3d{0.8, 0.8, 0.8} : std::get<Vec3d>(*situation.setup.texture);
  Hypothesis plain{.id = image ? "texture-missing" : "surface-color",
                   .rung = Rung::kTexture,
                   .parameters = {{"r", own.x, 0.02, 0, 10},
                                  {"g", own.y, 0.02, 0, 10},
                                  {"b", own.z, 0.02, 0, 10}},
                   .apply =
                       [](Setup& s, std::span<const double> p) {
                         s.texture = std::make_shared<const Texture>(Vec3d{p[0], p[1], p[2]});
                       },
                   .sentence =
                       [image](std::span<const double> p) {
                         return fmt::format(
                             "{} {}",
                             image ? "one colour instead of the texture," : "the surface's colour",
                             point({p[0], p[1], p[2]}));
                       }};
  return {plain};
}

}  // namespace lumaknot::diagnosis
