/// The orientation of the tube's rings along a centre line.
#pragma once

#include <vector>

#include "meshgen/spine.h"

namespace lumaknot {

/// The rings' frames; `arc_lengths` are theirs, as computed by the spine. The last coincides with
/// the first; the mismatch measures how well the rule closes.
///
/// kRotationMinimizing is the spine's exact frame. kDoubleReflection steps from ring to ring (Wang,
/// Juettler, Zheng, Liu: Computation of Rotation Minimizing Frames, 2008) and distributes the
/// mismatch over the arc length, including the step from the last ring to the first; it converges
/// to the exact frame at order 4. The others reproduce other tools. Throws Error, naming the place
/// and the remedy, where a rule leaves the frame undefined or turns it by more than a quarter turn
/// from one ring to the next, which only kThree may do.
std::vector<RingFrame> ring_frames(const Spine& spine, FrameRule rule,
                                   std::span<const double> arc_lengths);

/// The frame of `rule` at the parameter t, in radians, which the rings approach as they become
/// closer; for kDoubleReflection it is the exact frame. Not a number where the rule leaves it
/// undefined.
RingFrame frame_at(const Spine& spine, FrameRule rule, double t);

/// The angle by which frames turn about the centre line from the first to the last, relative to a
/// frame of minimal twist, in radians. Steps must be small: each is taken to be less than half a
/// turn.
double twist(const std::vector<RingFrame>& frames);

}  // namespace lumaknot
