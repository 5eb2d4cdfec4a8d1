/// The picture mirrored, as by a left-handed camera, or upside down.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> mirror(const Situation&) {
  const auto mirrored = [](std::string id, std::string sentence, double x, double y) {
    return discrete(std::move(id), Rung::kPlacement, std::move(sentence), [x, y](Setup& s) {
      s.picture.placement.scale_x *= x;
      s.picture.placement.scale_y *= y;
    });
  };
  return {mirrored("mirror-x", "left and right exchanged", -1, 1),
          mirrored("mirror-y", "top and bottom exchanged", 1, -1),
          mirrored("rotated-180", "turned by 180 degrees", -1, -1)};
}

}  // namespace lumaknot::diagnosis
