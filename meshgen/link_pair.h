/// Pairs of points of a link, and the local minima of their distance.
#pragma once

#include <vector>

#include "meshgen/curve.h"
#include "meshgen/spine.h"

namespace lumaknot {

/// Two points of a link.
struct LinkPair {
  int component_a = 0, component_b = 0;
  double t_a = 0, t_b = 0;  ///< in radians, also beyond one loop
  double distance = 0;      ///< in scene units
};

/// A link of congruent components, q not zero, searched for pairs.
struct PairedLink {
  std::vector<Curve> components;
  PeriodicIntegral speed;  ///< |C'| as a function of the meridian angle
  double length;           ///< of a component
  double near;  ///< points of one component with a shorter arc between them are not a pair
};

/// The link, with equal meridians.
PairedLink paired_link(const std::vector<Curve>& components, double near);

/// The arc length between two meridian angles, negative when it runs against the parameter.
double arc_between(const PairedLink& link, double psi_a, double psi_b);

/// The pair with its distance.
LinkPair measured(const PairedLink& link, LinkPair pair);

/// Whether the points are a pair: on two components, or with both arcs between them at least
/// `near`.
bool is_apart(const PairedLink& link, const LinkPair& pair);

/// The local minimum of the distance below `pair`, to rounding, as long as the path leads through
/// pairs only: Newton's method, damped where it does not descend (Levenberg and Marquardt).
LinkPair settled(const PairedLink& link, LinkPair pair);

}  // namespace lumaknot
