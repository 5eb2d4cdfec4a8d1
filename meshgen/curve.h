/// Centre lines: the components of a (p,q) torus link about +Z.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace lumaknot {

/// One closed component: with longitude phi = p t + longitude, meridian psi = q t + meridian, R the
/// ring's radius and w the winding's,
///   C(t) = ((R + w cos psi) cos phi, (R + w cos psi) sin phi, w sin psi),  0 <= t <= 2 pi.
struct Curve {
  int p = 2, q = 3;  ///< coprime; not both zero
  double ring_radius = 1, winding_radius = 0.4;
  double longitude = 0, meridian = 0;  ///< phases, radians
};

/// The gcd(|p|, |q|) components of `knot`: each the first turned about the axis by 2 pi / |q|
/// more, or, when q is zero, about the ring's circle by 2 pi / |p|. Throws Error when a component
/// has no extent.
std::vector<Curve> components(const KnotSpec& knot);

/// A point of the curve and its exact derivatives by the parameter, in scene units a radian^k.
struct CurvePoint {
  Vec3d position, first, second, third;
};

/// The point at the parameter t, in radians.
CurvePoint curve_point(const Curve& curve, double t);

/// The parameter 2 pi i / n for 0 <= i <= n.
double ring_parameter(int i, int n);

/// |C'(t)|, in scene units a radian.
double speed(const Curve& curve, double t);

/// |C' x C''| / |C'|^3, in 1 / scene units.
double curvature(const CurvePoint& point);

/// (C' x C'') . C''' / |C' x C''|^2, in 1 / scene units; not a number where the curvature is zero.
double torsion(const CurvePoint& point);

}  // namespace lumaknot
