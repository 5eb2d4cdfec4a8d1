/// Colours limited to [0, 1], or rounded to few levels.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> range(const Situation& situation) {
  std::vector<Hypothesis> all{discrete("limited", Rung::kEncoding, "its colours limited to [0, 1]",
                                       [](Setup& s) { s.color.limited = true; })};
  for (const int bits : {3, 4, 5, 6, 7, 8}) {
    if (bits == 8 && situation.eight_bits) continue;
    all.push_back(discrete(fmt::format("bits-{}", bits), Rung::kEncoding,
                           fmt::format("{} bits per channel", bits),
                           [bits](Setup& s) { s.color.levels = 1 << bits; }));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
