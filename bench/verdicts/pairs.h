/// Two faults at once.
#pragma once

#include <cstdint>

namespace lumaknot::verdicts {

struct PairCounts {
  long long pairs = 0, both_named = 0, wrong = 0, unknown = 0, unseen = 0;
  double seconds = 0;  ///< of processor time, all together
};

/// Plants `count` random pairs of the self-test's faults in its scene, and tells of each that is
/// not named, on standard error. `eight_bits`: pictures are kept so.
PairCounts count_pairs(long long count, std::uint64_t seed, bool eight_bits);

}  // namespace lumaknot::verdicts
