/// How the tube's rings stand along a centre line.
#pragma once

#include <vector>

#include "meshgen/spine.h"

namespace lumaknot {

/// The rings' frames; `arc_lengths` are theirs, as the spine has them. The last stands on the
/// first; how far it misses it tells how well the rule closes.
///
/// kRotationMinimizing is the spine's exact frame. kDoubleReflection steps from ring to ring (Wang,
/// Juettler, Zheng, Liu: Computation of Rotation Minimizing Frames, 2008) and spreads what the loop
/// misses over the arc length, the way from the last ring to the first included; it converges to
/// the exact frame at order 4. The others are what other tools do. Throws Error, naming the place
/// and the remedy, where a rule leaves the frame undefined or turns it by more than a quarter from
/// one ring to the next, which kThree alone may.
std::vector<Frame> ring_frames(const Spine& spine, FrameRule rule,
                               std::span<const double> arc_lengths);

/// The frame of `rule` at the parameter t, in radians, which the rings approach as they become
/// closer; kDoubleReflection's is the exact frame. Not a number where the rule leaves it undefined.
Frame frame_at(const Spine& spine, FrameRule rule, double t);

/// The angle by which frames turn about the centre line from the first to the last, against one
/// that twists least, in radians. Steps must be small: each is taken to be less than half a turn.
double twist(const std::vector<Frame>& frames);

}  // namespace lumaknot
