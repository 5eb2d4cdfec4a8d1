#include "meshgen/frames.h"

#include <fmt/format.h>

#include <numbers>

#include "scene/error.h"
#include "scene/fields.h"

namespace lumaknot {
namespace {

Frame frame_with(const Vec3d& position, const Vec3d& tangent, const Vec3d& across) {
  const Vec3d unit = normalize(across - tangent * dot(across, tangent));
  return {position, tangent, unit, cross(unit, tangent)};
}

/// `a` mirrored in the plane through the origin with normal `v`; `a` itself when v is zero.
Vec3d reflect(const Vec3d& a, const Vec3d& v) {
  const double square = dot(v, v);
  return square > 0 ? a - v * (2 * dot(v, a) / square) : a;
}

/// One step of the double reflection: into the plane between the points, then onto the tangent.
Frame step(const Frame& from, const Vec3d& position, const Vec3d& tangent) {
  const Vec3d chord = position - from.position;
  const Vec3d across = reflect(from.across, chord), along = reflect(from.tangent, chord);
  return frame_with(position, tangent, reflect(across, tangent - along));
}

/// The angle from the `across` of `first` to that of `last`, which has the same tangent.
double angle_from(const Frame& first, const Frame& last) {
  return std::atan2(dot(last.across, first.over), dot(last.across, first.across));
}

Frame turned(const Frame& f, double angle) {
  return frame_with(f.position, f.tangent, f.across * std::cos(angle) + f.over * std::sin(angle));
}

std::vector<Frame> double_reflection(const Spine& spine, std::span<const double> arc_lengths) {
  const std::vector<Turn> turns = ring_turns(spine.curve(), int(arc_lengths.size()) - 1);
  std::vector<Frame> frames{spine.frame(0)};
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const CurvePoint point = curve_point(spine.curve(), turns[i]);
    frames.push_back(step(frames.back(), point.position, normalize(point.first)));
  }
  const double missing = angle_from(frames.front(), frames.back());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    frames[i] = turned(frames[i], -missing * (arc_lengths[i] / spine.length()));
  }
  return frames;
}

Frame frenet(const Curve& curve, const Turn& at) {
  const CurvePoint point = curve_point(curve, at);
  const Vec3d tangent = normalize(point.first);
  return frame_with(point.position, tangent, point.second / dot(point.first, point.first));
}

Frame fixed_up(const Curve& curve, const Turn& at) {
  const CurvePoint point = curve_point(curve, at);
  return frame_with(point.position, normalize(point.first), {0, 0, 1});
}

/// three.js's frame: the ring's plane holds the normal of the plane through the origin, the point
/// and one 0.01 radians of longitude farther on; tilted against the centre line by what a finite
/// difference errs. `tangent` is that difference, unit. Not a number where it is undefined.
Frame three_frame(const Curve& curve, const Turn& at) {
  const double rate = 0.01 / curve.p;
  const Turn next{sum(at.longitude, direction_of(rate * curve.p)),
                  sum(at.meridian, direction_of(rate * curve.q))};
  const Vec3d here = curve_point(curve, at).position, there = curve_point(curve, next).position;
  const Vec3d along = there - here, over = cross(along, there + here);
  return {here, normalize(along), -normalize(cross(over, along)), normalize(over)};
}

Frame frame_by(FrameRule rule, const Curve& curve, const Turn& at) {
  switch (rule) {
    case FrameRule::kFrenet:
      return frenet(curve, at);
    case FrameRule::kFixedUp:
      return fixed_up(curve, at);
    default:
      return three_frame(curve, at);
  }
}

/// The turn from `a` to `b` about the centre line, in (-pi, pi], after the least turn that takes
/// tangent to tangent.
double twist_between(const Frame& a, const Frame& b) {
  const Frame carried = step(a, b.position, b.tangent);
  return angle_from(carried, b);
}

void check_defined(const std::vector<Frame>& frames, FrameRule rule, const Curve& curve) {
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    const bool finite = is_finite(frames[i].across) && is_finite(frames[i].tangent);
    // three.js draws rings that turn over, and so its vertices have them.
    if (finite && (rule == FrameRule::kThree ||
                   std::abs(twist_between(frames[i], frames[i + 1])) < std::numbers::pi / 2)) {
      continue;
    }
    throw Error(fmt::format(
        "frames \"{}\" are undefined on the ({},{}) knot near t = {:.4f} (ring {} of {}{}); use "
        "\"rotation-minimizing\"",
        kFrameNames[std::size_t(rule)], curve.p, curve.q,
        ring_parameter(int(i), int(frames.size()) - 1), i, frames.size() - 1,
        finite ? ", which turns by more than a quarter to the next" : ""));
  }
}

}  // namespace

std::vector<Frame> ring_frames(const Spine& spine, FrameRule rule,
                               std::span<const double> arc_lengths) {
  if (rule == FrameRule::kRotationMinimizing) return spine.frames(arc_lengths);
  if (rule == FrameRule::kDoubleReflection) return double_reflection(spine, arc_lengths);
  std::vector<Frame> frames;
  for (const Turn& at : ring_turns(spine.curve(), int(arc_lengths.size()) - 1)) {
    frames.push_back(frame_by(rule, spine.curve(), at));
  }
  check_defined(frames, rule, spine.curve());
  return frames;
}

Frame frame_at(const Spine& spine, FrameRule rule, double t) {
  if (rule == FrameRule::kRotationMinimizing || rule == FrameRule::kDoubleReflection) {
    return spine.frame(t);
  }
  return frame_by(rule, spine.curve(), turn_of(spine.curve(), t));
}

double twist(const std::vector<Frame>& frames) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    sum -= twist_between(frames[i], frames[i + 1]);  // across to over: about minus the tangent
  }
  return sum;
}

}  // namespace lumaknot
