/// Channels exchanged.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> channels(const Situation&) {
  std::vector<Hypothesis> all;
  all.reserve(std::size(kPermutations));
  for (const Permutation& p : kPermutations) {
    all.push_back(discrete(fmt::format("channels-{}", p.name), Rung::kEncoding,
                           fmt::format("its channels in the order {}", p.name),
                           [p](Setup& s) { s.color.channels = p.order; }));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
