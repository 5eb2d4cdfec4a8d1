/// What the tests of clearance() share.
#pragma once

#include <numbers>

#include "meshgen/clearance.h"

namespace lumaknot::testing {

inline constexpr double kPi = std::numbers::pi;

inline KnotSpec knot_of(int p, int q, double winding_radius = 0.4, double ring_radius = 1) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  knot.ring_radius = ring_radius;
  knot.winding_radius = winding_radius;
  return knot;
}

inline Clearance clearance_of(const KnotSpec& knot) { return clearance(components(knot)); }

}  // namespace lumaknot::testing
