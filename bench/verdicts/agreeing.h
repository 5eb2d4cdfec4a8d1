/// Renderers that agree must not be accused.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lumaknot::verdicts {

/// What was said of one renderer's pictures of random scenes.
struct AgreeingCounts {
  std::string renderer;
  long long scenes = 0;   ///< drawn and compared
  long long skipped = 0;  ///< not drawn, or only otherwise than asked
  long long failed = 0;
  long long differed = 0;   ///< the verdict of the texture, the terms or the final picture
  long long explained = 0;  ///< more of a picture than allowed has a known cause
  long long diagnosed = 0;  ///< final pictures as floats, with 16 and with 8 bits
  long long known = 0;      ///< of those, some pixels differ for a known reason, which was named
  long long accused = 0;    ///< another cause was named
};

/// Draws `scenes` random scenes, those of the seeds from `seed` on, with each renderer (flags), and
/// tells of each that is not agreed on, on standard error.
std::vector<AgreeingCounts> count_agreeing(long long scenes, std::uint64_t seed,
                                           const std::vector<std::string>& renderers);

}  // namespace lumaknot::verdicts
