/// Tone curves: what makes a display's colours of a scene's.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "math/vec.h"

namespace lumaknot::diagnosis {

enum class Tone {
  kNone,
  kReinhard,
  kAces,        ///< K. Narkowicz's fit
  kAcesFitted,  ///< S. Hill's fit, with its matrices
  kHable,       ///< "Uncharted 2"
  kNeutral,     ///< Khronos' PBR Neutral
  kAgx,
  kCineon,
};

/// A colour of linear sRGB after the curve. Reinhard's is odd below zero as far as it can be, the
/// others cut negative values off where their logarithm or root needs it.
Vec3d toned(Tone tone, const Vec3d& color);

/// A smooth curve through points that lie closest about 0: their roots r (r^2 with r's sign is the
/// place) are spread evenly from `low` to `high`, low < high. There are four or more; it is
/// constant beyond, and linear in their values.
struct ToneSpline {
  double low = 0, high = 1;  ///< roots

  double at(double x, std::span<const double> values) const;
  /// Of up to four values, of which the first has index `first`.
  struct Weights {
    std::size_t first;
    std::array<double, 4> of;
  };
  Weights weights(double x, std::size_t count) const;
};

}  // namespace lumaknot::diagnosis
