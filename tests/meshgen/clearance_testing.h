/// Shared by the tests of clearance().
#pragma once

#include "math/angle.h"
#include "meshgen/clearance.h"

namespace lumaknot::testing {

inline KnotSpec knot_of(int p, int q, double minor_radius = 0.4, double major_radius = 1) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  knot.major_radius = major_radius;
  knot.minor_radius = minor_radius;
  return knot;
}

inline Clearance clearance_of(const KnotSpec& knot) { return clearance(components(knot)); }

}  // namespace lumaknot::testing
