/// Gain, offset, contrast, white balance.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> exposure(const Situation&) {
  Hypothesis balance{
      .id = "white-balance",
      .rung = Rung::kEncoding,
      .parameters = {{"r", 1, 0.02, 0, 1e4}, {"g", 1, 0.02, 0, 1e4}, {"b", 1, 0.02, 0, 1e4}},
      .apply = [](Setup& s, std::span<const double> p) { s.color.gain = {p[0], p[1], p[2]}; },
      .sentence =
          [](std::span<const double> p) {
            return "red, green and blue times " + point({p[0], p[1], p[2]});
          }};
  return {
      continuous("exposure", Rung::kEncoding, {"gain", 1, 0.02, 0, 1e4}, "an exposure of {:.4g}",
                 [](Setup& s, double gain) { s.color.gain = {gain, gain, gain}; }),
      continuous("offset", Rung::kEncoding, {"offset", 0, 0.01, -10, 10},
                 "an offset of {:.4g} added to its colours",
                 [](Setup& s, double offset) { s.color.offset = offset; }),
      continuous("contrast", Rung::kEncoding, {"contrast", 1, 0.02, 0, 100},
                 "a contrast of {:.4g} about the middle grey",
                 [](Setup& s, double contrast) { s.color.contrast = contrast; }),
      balance};
}

}  // namespace lumaknot::diagnosis
