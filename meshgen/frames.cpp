#include "meshgen/frames.h"

#include <fmt/format.h>

#include "math/angle.h"
#include "scene/fields.h"
#include "system/error.h"

namespace lumaknot {
namespace {

RingFrame frame_with(const Vec3d& position, const Vec3d& tangent, const Vec3d& normal) {
  const Vec3d unit = normalize(normal - tangent * dot(normal, tangent));
  return {position, tangent, unit, cross(unit, tangent)};
}

/// `a` reflected in the plane through the origin with normal `v`; `a` itself when v is zero.
Vec3d reflect(const Vec3d& a, const Vec3d& v) {
  const double square = dot(v, v);
  return square > 0 ? a - v * (2 * dot(v, a) / square) : a;
}

/// One step of the double reflection: in the plane between the points, then onto the tangent.
RingFrame step(const RingFrame& from, const Vec3d& position, const Vec3d& tangent) {
  const Vec3d chord = position - from.position;
  const Vec3d normal = reflect(from.normal, chord), along = reflect(from.tangent, chord);
  return frame_with(position, tangent, reflect(normal, tangent - along));
}

/// The angle from the `normal` of `first` to that of `last`, which has the same tangent.
double angle_from(const RingFrame& first, const RingFrame& last) {
  return std::atan2(dot(last.normal, first.binormal), dot(last.normal, first.normal));
}

RingFrame turned(const RingFrame& f, double angle) {
  return frame_with(f.position, f.tangent,
                    f.normal * std::cos(angle) + f.binormal * std::sin(angle));
}

std::vector<RingFrame> double_reflection(const Spine& spine, std::span<const double> arc_lengths) {
  const std::vector<TorusAngles> angles = ring_angles(spine.curve(), int(arc_lengths.size()) - 1);
  std::vector<RingFrame> frames{spine.frame(0)};
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const CurvePoint point = curve_point(spine.curve(), angles[i]);
    frames.push_back(step(frames.back(), point.position, normalize(point.first)));
  }
  const double missing = angle_from(frames.front(), frames.back());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    frames[i] = turned(frames[i], -missing * (arc_lengths[i] / spine.length()));
  }
  return frames;
}

RingFrame frenet(const Curve& curve, const TorusAngles& at) {
  const CurvePoint point = curve_point(curve, at);
  const Vec3d tangent = normalize(point.first);
  return frame_with(point.position, tangent, point.second / dot(point.first, point.first));
}

RingFrame fixed_up(const Curve& curve, const TorusAngles& at) {
  const CurvePoint point = curve_point(curve, at);
  return frame_with(point.position, normalize(point.first), {0, 0, 1});
}

/// three.js's frame: the ring's plane contains the normal of the plane through the origin, the
/// point and one 0.01 radians of longitude farther on; tilted relative to the centre line by the
/// error of a finite difference. `tangent` is that difference, unit. Not a number where it is
/// undefined.
RingFrame three_frame(const Curve& curve, const TorusAngles& at) {
  const double rate = 0.01 / curve.p;
  const TorusAngles next{sum(at.longitude, sin_cos(rate * curve.p)),
                         sum(at.meridian, sin_cos(rate * curve.q))};
  const Vec3d here = curve_point(curve, at).position, there = curve_point(curve, next).position;
  const Vec3d along = there - here, binormal = cross(along, there + here);
  return {here, normalize(along), -normalize(cross(binormal, along)), normalize(binormal)};
}

RingFrame frame_by(FrameRule rule, const Curve& curve, const TorusAngles& at) {
  switch (rule) {
    case FrameRule::kFrenet:
      return frenet(curve, at);
    case FrameRule::kFixedUp:
      return fixed_up(curve, at);
    default:
      return three_frame(curve, at);
  }
}

/// The rotation from `a` to `b` about the centre line, in (-pi, pi], after the smallest rotation
/// that maps tangent to tangent.
double twist_between(const RingFrame& a, const RingFrame& b) {
  const RingFrame carried = step(a, b.position, b.tangent);
  return angle_from(carried, b);
}

void check_defined(const std::vector<RingFrame>& frames, FrameRule rule, const Curve& curve) {
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    const bool finite = is_finite(frames[i].normal) && is_finite(frames[i].tangent);
    // three.js draws rings that flip, so its vertices have them.
    if (finite && (rule == FrameRule::kThree ||
                   std::abs(twist_between(frames[i], frames[i + 1])) < kPi / 2)) {
      continue;
    }
    throw Error(fmt::format(
        "frames \"{}\" are undefined on the ({},{}) knot near t = {:.4f} (ring {} of {}{}); use "
        "\"rotation-minimizing\"",
        kFrameNames[std::size_t(rule)], curve.p, curve.q,
        ring_parameter(int(i), int(frames.size()) - 1), i, frames.size() - 1,
        finite ? ", which turns by more than a quarter turn to the next" : ""));
  }
}

}  // namespace

std::vector<RingFrame> ring_frames(const Spine& spine, FrameRule rule,
                                   std::span<const double> arc_lengths) {
  if (rule == FrameRule::kRotationMinimizing) return spine.frames(arc_lengths);
  if (rule == FrameRule::kDoubleReflection) return double_reflection(spine, arc_lengths);
  std::vector<RingFrame> frames;
  for (const TorusAngles& at : ring_angles(spine.curve(), int(arc_lengths.size()) - 1)) {
    frames.push_back(frame_by(rule, spine.curve(), at));
  }
  check_defined(frames, rule, spine.curve());
  return frames;
}

RingFrame frame_at(const Spine& spine, FrameRule rule, double t) {
  if (rule == FrameRule::kRotationMinimizing || rule == FrameRule::kDoubleReflection) {
    return spine.frame(t);
  }
  return frame_by(rule, spine.curve(), torus_angles(spine.curve(), t));
}

double twist(const std::vector<RingFrame>& frames) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    sum -= twist_between(frames[i], frames[i + 1]);  // normal to binormal: about minus the tangent
  }
  return sum;
}

}  // namespace lumaknot
