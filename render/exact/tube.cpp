#include "render/exact/tube.h"

#include <fmt/format.h>

#include <cmath>

#include "math/angle.h"
#include "meshgen/knot_mesh.h"
#include "scene/check.h"
#include "system/error.h"

namespace lumaknot::exact {
namespace {

std::vector<Curve> exact_lines(const KnotSpec& knot) {
  check_knot(knot, "mesh.knot.");
  if (knot.frames == FrameRule::kThree) {
    throw Error(
        "mesh.knot.frames \"three\" has no exact surface: it tilts the rings, so no grid "
        "makes a round tube; do not use frames \"three\" or conventions \"three\" or \"babylon\"");
  }
  return centre_lines(knot);
}

std::vector<Spine> spines_of(const KnotSpec& knot) {
  std::vector<Spine> spines;
  for (const Curve& curve : exact_lines(knot)) {
    spines.emplace_back(curve);
    // Rejects undefined frames.
    ring_frames(spines.back(), knot.frames, spines.back().arc_lengths(knot.segments));
  }
  return spines;
}

}  // namespace

ExactTube::ExactTube(const KnotSpec& knot)
    : knot_(knot), spines_(spines_of(knot)), rays_(exact_lines(knot), knot.tube_radius) {}

ExactFragment ExactTube::first(const Ray& ray, double beyond) const {
  const FirstHit found = rays_.first(ray, beyond);
  ExactFragment seen;
  seen.decided = found.decided;
  if (!found.hit) return seen;
  const TubeHit& hit = *found.hit;
  const Spine& spine = spines_[hit.curve];
  const RingFrame frame = frame_at(spine, knot_.frames, hit.t);
  const double angle = std::atan2(dot(hit.normal, frame.binormal), dot(hit.normal, frame.normal));
  seen.t = hit.t;
  seen.theta = angle < 0 ? std::max(angle + kTurn, 0.0) : angle;
  const double along =
      knot_.unwrap == Unwrap::kParameter ? hit.t / kTurn : spine.arc_length(hit.t) / spine.length();
  seen.fragment = {std::int64_t(hit.curve),
                   hit.distance,
                   hit.position,
                   hit.normal,
                   {knot_.repeat_u * along, knot_.repeat_v * seen.theta / kTurn},
                   {}};
  return seen;
}

}  // namespace lumaknot::exact
