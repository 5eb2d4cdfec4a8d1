#include "validate/renderers/cycles_filter.h"

#include <cmath>

#include "math/angle.h"

namespace lumaknot::validate {

double cycles_filter(double offset) {
  const double turn = kPi * (offset / kCyclesReach + 1);
  const double window = 0.35875 - 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) -
                        0.01168 * std::cos(3 * turn);
  const double share = std::abs(offset) < kCyclesReach ? window / (0.35875 * 2 * kCyclesReach) : 0;
  const double spread = offset > -0.5 && offset < 1.5 ? 0.5 : 0;
  return (1022 * share + spread) / 1023;
}

}  // namespace lumaknot::validate
