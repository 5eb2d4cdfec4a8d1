#include "meshgen/frames.h"

#include <numbers>

#include "meshgen/curve.h"

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

/// segments + 1 frames from t = 0 to t = 2 pi: the last stands on the first, turned.
std::vector<Frame> open_frames(const KnotSpec& knot) {
  std::vector<Frame> frames;
  frames.reserve(std::size_t(knot.segments) + 1);
  for (int i = 0; i <= knot.segments; ++i) {
    // The last point is the first to the bit, not its neighbour by rounding of 2 pi.
    const double t = 2 * std::numbers::pi * (i % knot.segments) / knot.segments;
    const CurvePoint point = curve_point(knot, t);
    const Vec3d tangent = normalize(point.derivative);
    frames.push_back(i == 0 ? frame_with(point.position, tangent, {1, 0, 0})
                            : step(frames.back(), point.position, tangent));
  }
  return frames;
}

double angle_from(const Frame& first, const Frame& last) {
  return std::atan2(dot(last.across, first.over), dot(last.across, first.across));
}

}  // namespace

std::vector<Frame> closed_frames(const KnotSpec& knot) {
  std::vector<Frame> frames = open_frames(knot);
  const double missing = angle_from(frames.front(), frames.back());
  frames.pop_back();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double turn = -missing * double(i) / knot.segments;
    Frame& f = frames[i];
    f = frame_with(f.position, f.tangent, f.across * std::cos(turn) + f.over * std::sin(turn));
  }
  return frames;
}

double closing_angle(const KnotSpec& knot) {
  const std::vector<Frame> frames = open_frames(knot);
  return angle_from(frames.front(), frames.back());
}

}  // namespace lumaknot
