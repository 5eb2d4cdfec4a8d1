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

std::vector<Frame> double_reflection(const Spine& spine, int segments) {
  std::vector<Frame> frames{spine.frame(0)};
  for (int i = 1; i <= segments; ++i) {
    // The last point is the first to the bit, not its neighbour by rounding of 2 pi.
    const CurvePoint point = curve_point(spine.curve(), ring_parameter(i % segments, segments));
    frames.push_back(step(frames.back(), point.position, normalize(point.first)));
  }
  const double missing = angle_from(frames.front(), frames.back());
  for (int i = 0; i <= segments; ++i) {
    const double share = spine.arc_length(ring_parameter(i, segments)) / spine.length();
    frames[std::size_t(i)] = turned(frames[std::size_t(i)], -missing * share);
  }
  return frames;
}

Frame frenet(const Curve& curve, double t) {
  const CurvePoint point = curve_point(curve, t);
  const Vec3d tangent = normalize(point.first);
  return frame_with(point.position, tangent, point.second / dot(point.first, point.first));
}

Frame fixed_up(const Curve& curve, double t) {
  const CurvePoint point = curve_point(curve, t);
  return frame_with(point.position, normalize(point.first), {0, 0, 1});
}

Frame frame_by(const Spine& spine, FrameRule rule, double t) {
  switch (rule) {
    case FrameRule::kFrenet:
      return frenet(spine.curve(), t);
    case FrameRule::kFixedUp:
      return fixed_up(spine.curve(), t);
    case FrameRule::kThree:
      return three_frame(spine.curve(), t);
    default:
      return spine.frame(t);
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

Frame three_frame(const Curve& curve, double t) {
  const Vec3d here = curve_point(curve, t).position;
  const Vec3d there = curve_point(curve, t + 0.01 / curve.p).position;
  const Vec3d along = there - here, over = cross(along, there + here);
  return {here, normalize(along), -normalize(cross(over, along)), normalize(over)};
}

std::vector<Frame> ring_frames(const Spine& spine, FrameRule rule, int segments) {
  if (rule == FrameRule::kDoubleReflection) return double_reflection(spine, segments);
  std::vector<Frame> frames;
  frames.reserve(std::size_t(segments) + 1);
  for (int i = 0; i <= segments; ++i) {
    frames.push_back(frame_by(spine, rule, ring_parameter(i, segments)));
  }
  if (rule != FrameRule::kRotationMinimizing) check_defined(frames, rule, spine.curve());
  return frames;
}

double twist(const std::vector<Frame>& frames) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    sum -= twist_between(frames[i], frames[i + 1]);  // across to over: about minus the tangent
  }
  return sum;
}

}  // namespace lumaknot
