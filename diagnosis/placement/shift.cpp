/// The picture moved by whole or part pixels: by its camera, or a finished picture.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> shift(const Situation&) {
  const auto moved = [](Setup& s, std::span<const double> p) {
    s.picture.placement.shift_x = p[0];
    s.picture.placement.shift_y = p[1];
  };
  Hypothesis rendered{.id = "shift",
                      .rung = Rung::kPlacement,
                      .parameters = {{"x", 0, 0.5, -1e4, 1e4}, {"y", 0, 0.5, -1e4, 1e4}},
                      .apply = moved,
                      .sentence = [](std::span<const double> p) {
                        return fmt::format("moved by {} pixels to the right and {} down",
                                           number(p[0]), number(p[1]));
                      }};
  for (int x = -12; x <= 12; x += 4) {
    for (int y = -12; y <= 12; y += 4) rendered.starts.push_back({double(x), double(y)});
  }
  Hypothesis resampled = rendered;
  resampled.id = "shift-resampled";
  resampled.apply = [moved](Setup& s, std::span<const double> p) {
    moved(s, p);
    s.picture.resampled = true;
  };
  resampled.sentence = [](std::span<const double> p) {
    return fmt::format("moved, when finished, by {} pixels to the right and {} down", number(p[0]),
                       number(p[1]));
  };
  resampled.starts = {{0.25, 0.25}, {-0.25, 0.25}, {0.25, -0.25}, {-0.25, -0.25}};
  resampled.costly = true;
  return {rendered, resampled};
}

}  // namespace lumaknot::diagnosis
