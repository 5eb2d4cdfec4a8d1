/// How the tube's rings stand along a centre line.
#pragma once

#include <vector>

#include "meshgen/spine.h"

namespace lumaknot {

/// The rings' frames at t = 2 pi i / segments, i = 0 ... segments. The last stands on the first;
/// how far it misses it tells how well the rule closes.
///
/// kRotationMinimizing is the spine's exact frame. kDoubleReflection steps from ring to ring (Wang,
/// Juettler, Zheng, Liu: Computation of Rotation Minimizing Frames, 2008) and spreads what the loop
/// misses over the arc length, the way from the last ring to the first included; it converges to
/// the exact frame at order 4. The others are what other tools do. Throws Error, naming the place
/// and the remedy, where a rule leaves the frame undefined or turns it by more than a quarter from
/// one ring to the next, which kThree alone may.
std::vector<Frame> ring_frames(const Spine& spine, FrameRule rule, int segments);

/// three.js's frame: the ring's plane holds the normal of the plane through the origin, the point
/// and one 0.01 radians of longitude farther on; tilted against the centre line by what a finite
/// difference errs. `tangent` is that difference, unit. Not a number where it is undefined.
Frame three_frame(const Curve& curve, double t);

/// The angle by which frames turn about the centre line from the first to the last, against one
/// that twists least, in radians. Steps must be small: each is taken to be less than half a turn.
double twist(const std::vector<Frame>& frames);

}  // namespace lumaknot
