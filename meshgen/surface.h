/// The exact tube about a centre line.
#pragma once

#include "meshgen/spine.h"

namespace lumaknot {

/// A point of the tube with its derivatives by t and theta, in scene units per radian.
struct TubePoint {
  Vec3d position;
  Vec3d normal;         ///< unit, outward
  Vec3d along, around;  ///< dX/dt, dX/dtheta
};

/// X(t, theta) = C(t) + r (cos theta normal + sin theta binormal): the round tube of radius r about
/// a spine, in double precision.
class TubeSurface {
 public:
  TubeSurface(const Spine& spine, double tube_radius) : spine_(spine), radius_(tube_radius) {}

  const Spine& spine() const { return spine_; }
  double tube_radius() const { return radius_; }

  /// The point at t, theta in radians. `along` is exact too: it includes the frame's rotation.
  TubePoint at(double t, double theta) const;

 private:
  const Spine& spine_;
  double radius_;
};

}  // namespace lumaknot
