/// Frames along the centre line that twist as little as a closed curve allows.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace lumaknot {

/// An orthonormal frame on the centre line: `across` x `tangent` = `over`.
struct Frame {
  Vec3d position, tangent;
  Vec3d across, over;  ///< span the ring's plane, across at angle 0 of the tube
};

/// Frames at t = 2 pi i / segments, i = 0 ... segments - 1. Rotation minimising by double
/// reflection (Wang, Juettler, Zheng, Liu: Computation of Rotation Minimizing Frames, 2008), an
/// error of order 4 in the step; the angle missing when the loop closes is spread evenly over it,
/// so that the frame after the last is the first.
std::vector<Frame> closed_frames(const KnotSpec& knot);

/// The angle in (-pi, pi] by which the rotation-minimising frame misses itself after one loop.
double closing_angle(const KnotSpec& knot);

}  // namespace lumaknot
