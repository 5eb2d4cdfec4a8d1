/// Pixels that are not square, or the whole picture larger or smaller.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> aspect(const Situation&) {
  const auto scaled = [](std::string id, std::string format, bool x, bool y) {
    Hypothesis h = continuous(std::move(id), Rung::kPlacement, {"scale", 1, 0.01, 0.01, 100},
                              std::move(format), [x, y](Setup& s, double scale) {
                                if (x) s.picture.placement.scale_x *= scale;
                                if (y) s.picture.placement.scale_y *= scale;
                              });
    h.starts = {{1}, {0.75}, {1.3}, {0.5}, {2}};
    return h;
  };
  Hypothesis resampled = scaled("zoom-resampled", "scaled, when finished, by {:.4g}", true, true);
  const auto rendered = resampled.apply;
  resampled.apply = [rendered](Setup& s, std::span<const double> p) {
    rendered(s, p);
    s.picture.resampled = true;
  };
  resampled.starts = {{0.98}, {1.02}, {0.9}, {1.1}};
  resampled.costly = true;
  return {scaled("stretch-x", "{:.4g} times as wide", true, false),
          scaled("stretch-y", "{:.4g} times as high", false, true), resampled};
}

}  // namespace lumaknot::diagnosis
