/// Where a torus knot's centre line bends most.
#pragma once

#include "meshgen/curve.h"

namespace lumaknot {

/// The largest curvature of a curve.
struct Bend {
  double curvature;  ///< > 0, 1 / scene units, to about 1e-15 of itself
  double t;          ///< a parameter where it occurs, in [0, 2 pi); with q = 0 it occurs at all
};

/// The largest curvature of `curve`, whose minor radius must be > 0.
Bend sharpest_bend(const Curve& curve);

}  // namespace lumaknot
