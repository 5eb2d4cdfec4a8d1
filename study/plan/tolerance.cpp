#include "study/plan/tolerance.h"

#include <fmt/format.h>

#include "system/error.h"

namespace lumaknot::plan {

void check_tolerance(const Tolerance& tolerance, bool area) {
  constexpr double kFarthest = 16;  // pixels; farther away is another picture
  if (!(tolerance.color > 0 && tolerance.color < 1)) {
    throw Error(fmt::format(
        "--tolerance must be > 0 and < 1, since colours are from 0 to 1, got {:g}; say 1/255",
        tolerance.color));
  }
  const double finest = area ? kAreaTruthError : kPointTruthError;
  if (tolerance.color <= finest) {
    throw Error(fmt::format(
        "--tolerance {:g} is finer than the truth, which is known to {:g}{}; allow more",
        tolerance.color, finest, area ? " where image.samples is above 1" : ""));
  }
  if (!(tolerance.shift >= 0 && tolerance.shift <= kFarthest)) {
    throw Error(fmt::format("--shift must be from 0 to {} pixels, got {}; say 0.25", kFarthest,
                            tolerance.shift));
  }
}

}  // namespace lumaknot::plan
