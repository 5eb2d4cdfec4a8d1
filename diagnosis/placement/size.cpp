/// A picture of another size than the scene asks for.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

namespace {

/// A part of our picture, or our picture with a margin, as it was drawn.
Hypothesis cut_out(const ImageSpec& own, const ImageSpec& theirs) {
  const double spare_x = own.width - theirs.width, spare_y = own.height - theirs.height;
  const double scale = double(own.height) / theirs.height;
  Hypothesis h{.id = "size-cut",
               .rung = Rung::kPlacement,
               .parameters = {{"left", 0.5 * spare_x, 0.5, -1e5, 1e5},
                              {"top", 0.5 * spare_y, 0.5, -1e5, 1e5}},
               .apply =
                   [=](Setup& s, std::span<const double> p) {
                     s.picture.placement.scale_x *= scale;
                     s.picture.placement.scale_y *= scale;
                     s.picture.placement.shift_x = 0.5 * spare_x - p[0];
                     s.picture.placement.shift_y = 0.5 * spare_y - p[1];
                   },
               .sentence =
                   [](std::span<const double> p) {
                     return fmt::format("cut out from {} pixels to the right and {} down",
                                        number(p[0]), number(p[1]));
                   }};
  constexpr int kSteps = 8;
  for (int x = 0; x <= kSteps; ++x) {
    for (int y = 0; y <= kSteps; ++y) {
      h.starts.push_back({spare_x * x / kSteps, spare_y * y / kSteps});
    }
  }
  return h;
}

}  // namespace

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
          scaled("size-cropped", "cropped about its centre", 1 / y, 1 / y), cut_out(own, theirs)};
}

}  // namespace lumaknot::diagnosis
