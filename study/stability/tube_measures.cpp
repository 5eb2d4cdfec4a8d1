#include "study/stability/tube_measures.h"

#include <algorithm>

#include "math/angle.h"
#include "meshgen/deviation.h"
#include "meshgen/tube_distance.h"

namespace lumaknot::stability {

double overlap(const KnotSpec& knot) {
  constexpr int kLines = 512, kRings = 128, kSides = 24;
  const Curve curve = components(knot).front();
  const Spine spine(curve);
  const TubeSurface tube(spine, knot.tube_radius);
  std::vector<CurvePoint> line;
  line.reserve(kLines);
  for (int k = 0; k < kLines; ++k) line.push_back(curve_point(curve, ring_parameter(k, kLines)));
  double nearest = knot.tube_radius;
  for (int i = 0; i < kRings * kSides; ++i) {
    const Vec3d x =
        tube.at(ring_parameter(i / kSides, kRings), kTurn * (i % kSides) / kSides).position;
    const auto square = [&](const CurvePoint& c) { return dot(c.position - x, c.position - x); };
    const auto min = std::ranges::min_element(line, {}, square);
    if (square(*min) > 1.1 * nearest * nearest) continue;
    const double t = ring_parameter(int(min - line.begin()), kLines);
    nearest = std::min(nearest, distance_near(curve, *min, t, x));
  }
  return 1 - nearest / knot.tube_radius;
}

double chord_share(const KnotSpec& knot) {
  const Spine spine(components(knot).front());
  return measured_chord(TubeSurface(spine, knot.tube_radius), knot.segments, knot.sides) /
         knot.tube_radius;
}

}  // namespace lumaknot::stability
