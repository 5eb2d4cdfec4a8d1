/// A picture of another size than the scene asks for.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> size(const Situation& situation) {
  const ImageSpec &own = situation.asked, &theirs = situation.setup.view.image;
  if (own.width == theirs.width && own.height == theirs.height) return {};
  const double x = double(theirs.width) / own.width, y = double(theirs.height) / own.height;
  const auto scaled = [](std::string id, std::string sentence, double sx, double sy) {
    return discrete(std::move(id), Rung::kPlacement, std::move(sentence), [sx, sy](Setup& s) {
      s.picture.placement.scale_x *= sx;
      s.picture.placement.scale_y *= sy;
    });
  };
  return {scaled("size-stretched", "stretched to its size", x / y, 1),
          scaled("size-horizontal", "its horizontal field of view kept", x / y, x / y),
          scaled("size-cropped", "cropped about its centre", 1 / y, 1 / y)};
}

}  // namespace lumaknot::diagnosis
