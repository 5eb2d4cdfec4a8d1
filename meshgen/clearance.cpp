// The minimum distance of two strands is found by branch and bound on pairs of intervals of the
// link, so that no sampling can be too coarse. Three facts reduce it to critical points:
// - Where no curvature exceeds k, points with an arc s <= pi / k between them are at least (2 / k)
//   sin(k s / 2) apart (Schur's comparison theorem, Chern: Curves and Surfaces in Euclidean Space,
//   1967).
// - For s < pi / k their chord is perpendicular to neither tangent, as tangents turn by at most k s
//   and so chord . T >= sin(k s) / k > 0. Such pairs are left out.
// - For s = pi / k they are 2 / k apart, where curvature already sets the limit. So a smaller
//   distance that is the minimum over the other pairs is not on their border, but critical.
// Rotations about the axis by 2 pi / |q| map each component to itself. A half turn about a line
// from the axis through a point farthest from it maps the link to itself. So one point of the pair
// can be taken from the first component, with a meridian angle in [0, pi].

#include "meshgen/clearance.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <queue>
#include <utility>

#include "math/angle.h"
#include "meshgen/link_pair.h"
#include "meshgen/quadratic.h"
#include "meshgen/sharpest_bend.h"

namespace lumaknot {
namespace {

constexpr double kTolerance = 1e-6;  // see Clearance::radius

/// The numbers within `half` of `middle`.
struct Range {
  double middle, half;
};

/// Pairs of a point a of the first component, at the meridian angle psi, and a point b of
/// `component`, with the parameter t_b = t_a + shift. With everything rotated about the axis so
/// that a has longitude 0, both move with psi as smoothly as on circles, however often the link
/// winds.
struct Cell {
  int component;
  Range psi, shift;
  double min = 0;           // no pair is closer
  LinkPair likely{};        // the closest one according to a quadratic model
  bool psi_longer = false;  // whether psi changes the chord more than shift does
};

struct LargerLeast {
  bool operator()(const Cell& a, const Cell& b) const { return a.min > b.min; }
};
using Cells = std::priority_queue<Cell, std::vector<Cell>, LargerLeast>;

/// The position of b relative to a in the middle of a cell.
struct Offset {
  double longitude, meridian;  // angles
};

Offset offset_of(const PairedLink& link, const Cell& cell) {
  const Curve &a = link.components.front(), &b = link.components[std::size_t(cell.component)];
  return {a.p * cell.shift.middle + b.longitude - a.longitude, a.q * cell.shift.middle};
}

/// Half of the squared distance about the middle of the cell, with x in psi and y in shift.
Quadratic half_square(const PairedLink& link, const Cell& cell) {
  const auto& [p, q, ring, w, longitude, meridian] = link.components.front();
  const Offset offset = offset_of(link, cell);
  const double psi_a = cell.psi.middle, psi_b = psi_a + offset.meridian;
  const Vec3d out{std::cos(offset.longitude), std::sin(offset.longitude), 0}, up{0, 0, 1};
  const Vec3d along{-out.y, out.x, 0};
  // The torus' normals at a and b, and their derivatives by psi.
  const Vec3d normal_a{std::cos(psi_a), 0, std::sin(psi_a)}, rise_a{-normal_a.z, 0, normal_a.x};
  const Vec3d normal_b = out * std::cos(psi_b) + up * std::sin(psi_b);
  const Vec3d rise_b = up * std::cos(psi_b) - out * std::sin(psi_b);
  const CurvePoint b = curve_point({p, q, ring, w, offset.longitude, psi_b}, 0);
  const Vec3d chord = Vec3d{ring, 0, 0} + normal_a * w - b.position;
  const Vec3d by_x = (rise_a - rise_b) * w, by_xx = (normal_b - normal_a) * w;
  const Vec3d by_xy = (normal_b * q + along * (p * std::sin(psi_b))) * w;
  return {dot(chord, chord) / 2,
          dot(chord, by_x),
          -dot(chord, b.first),
          dot(by_x, by_x) + dot(chord, by_xx),
          dot(chord, by_xy) - dot(by_x, b.first),
          dot(b.first, b.first) - dot(chord, b.second)};
}

/// The distance of an angle from the nearest whole turn.
double angle_size(double angle) { return std::abs(std::remainder(angle, 2 * kPi)); }

/// Bounds on how the chord changes from the middle of a cell to its border.
struct Reach {
  double by_psi;                // through psi alone
  double first, second, third;  // derivatives of the chord towards a corner
};

/// A normal of the torus turns by no more than the angles change, and the chord's change through
/// psi alone is w times the difference of two normals, which differ by no more than the angles
/// between.
Reach reach_of(const PairedLink& link, const Cell& cell) {
  const Curve& curve = link.components.front();
  const double w = curve.minor_radius, psi = cell.psi.half;
  const double longitude = std::abs(curve.p) * cell.shift.half;
  const double meridian = std::abs(curve.q) * cell.shift.half;
  const Offset offset = offset_of(link, cell);
  const double apart = std::min(
      angle_size(offset.longitude) + longitude + angle_size(offset.meridian) + meridian, 2.0);
  const auto derivative = [&](int k) {
    const double psi_alone = std::pow(psi, k);
    return curve.major_radius * std::pow(longitude, k) +
           w * (std::pow(longitude + meridian + psi, k) - psi_alone + apart * psi_alone);
  };
  return {w * apart * psi, derivative(1), derivative(2), derivative(3)};
}

/// A lower bound of the distance of the cell's pairs. Taylor's theorem bounds the remainder of the
/// quadratic model. Rotated into one half plane of the axis, the points are no farther apart; there
/// they lie on one circle, unless that crosses the axis.
double min_distance(const PairedLink& link, const Cell& cell, const Reach& reach, double chord,
                    double min_half_square) {
  const double third = 3 * reach.first * reach.second + (chord + reach.first) * reach.third;
  const double curved = std::sqrt(2 * std::max(min_half_square - third / 6, 0.0));
  const Curve& curve = link.components.front();
  if (curve.major_radius < curve.minor_radius) return curved;
  const double angle =
      angle_size(offset_of(link, cell).meridian) - std::abs(curve.q) * cell.shift.half;
  return std::max(curved, 2 * curve.minor_radius * std::sin(std::max(angle, 0.0) / 2));
}

/// The cell with all its bounds.
Cell cell_of(const PairedLink& link, int component, const Range& psi, const Range& shift) {
  Cell cell{component, psi, shift};
  const Quadratic model = half_square(link, cell);
  const Minimum min = min_in_box(model, psi.half, shift.half);
  const Reach reach = reach_of(link, cell);
  cell.min = min_distance(link, cell, reach, std::sqrt(2 * model.value), min.value);
  cell.psi_longer = 2 * reach.by_psi > reach.first;
  const Curve& first = link.components.front();
  const double t_a = (psi.middle + min.x - first.meridian) / first.q;
  cell.likely = {0, component, t_a, t_a + shift.middle + min.y,
                 std::sqrt(2 * std::max(min.value, 0.0))};
  return cell;
}

/// Whether the arcs between the two points are short for the whole cell.
bool is_near(const PairedLink& link, const Cell& cell) {
  if (cell.component != 0) return false;
  const Curve& curve = link.components.front();
  const double p = std::abs(curve.p), q = std::abs(curve.q), w = curve.minor_radius;
  // With psi the arc changes by the difference of the speeds at its ends over q.
  const double fastest = std::hypot(w * q, p * (curve.major_radius + w));
  const double longest = std::abs(cell.shift.middle) + cell.shift.half;
  const double slack =
      cell.shift.half * fastest + cell.psi.half * std::min(p * w * longest, fastest / q);
  if (slack >= link.near) return false;
  const double psi = cell.psi.middle;
  const double arc = arc_between(link, psi, psi + curve.q * cell.shift.middle);
  return std::abs(std::remainder(arc, link.length)) + slack < link.near;
}

/// The cell cut across its longer side.
std::array<Cell, 2> halves(const PairedLink& link, const Cell& cell) {
  const auto half = [](const Range& range, int side) {
    return Range{range.middle + side * range.half / 2, range.half / 2};
  };
  const auto part = [&](int side) {
    return cell.psi_longer ? cell_of(link, cell.component, half(cell.psi, side), cell.shift)
                           : cell_of(link, cell.component, cell.psi, half(cell.shift, side));
  };
  return {part(-1), part(1)};
}

/// `best`, or the pair that the cell's likely pair leads to when that is closer.
LinkPair closer(const PairedLink& link, const Cell& cell, const LinkPair& best) {
  const double limit = best.distance * (1 - 1e-12);  // not for a change due to rounding
  if (cell.likely.distance >= limit) return best;
  const LinkPair pair = measured(link, cell.likely);
  return pair.distance < limit && is_apart(link, pair) ? settled(link, pair) : best;
}

/// A pair closer than `best`, or `best`: no pair is closer than that by more than the tolerance. A
/// distance below `resolution` ends the search.
LinkPair closest_pair(const PairedLink& link, LinkPair best, double resolution) {
  Cells cells;
  for (int i = 0; i < int(link.components.size()); ++i) {
    cells.push(cell_of(link, i, {kPi / 2, kPi / 2}, {0, kPi}));
  }
  while (!cells.empty() && best.distance > resolution) {
    const Cell cell = cells.top();
    cells.pop();
    best = closer(link, cell, best);
    const double limit = best.distance - std::max(kTolerance * best.distance, resolution);
    if (cell.min >= limit) break;
    for (const Cell& half : halves(link, cell)) {
      if (half.min < limit && !is_near(link, half)) cells.push(half);
    }
  }
  return best;
}

/// The largest tube about circles around the axis. Two of them are nearest within a half plane of
/// it.
Clearance coaxial_clearance(const std::vector<Curve>& circles) {
  std::vector<Vec3d> points;
  points.reserve(circles.size());
  for (const Curve& circle : circles) points.push_back(curve_point(circle, 0).position);
  const auto radius = [](const Vec3d& point) { return std::hypot(point.x, point.y); };
  const int count = int(circles.size());
  Clearance min{radius(points[0]), true};
  for (int i = 0; i < count; ++i) {
    const Vec3d& b = points[std::size_t(i)];
    if (radius(b) < min.radius) min = {radius(b), true, i, i};
    for (int j = 0; j < i; ++j) {
      const Vec3d& a = points[std::size_t(j)];
      const double half = std::hypot(radius(a) - radius(b), a.z - b.z) / 2;
      const bool opposite = a.x * b.x + a.y * b.y < 0;
      if (half < min.radius) min = {half, false, j, i, 0, opposite ? kPi : 0};
    }
  }
  return min;
}

/// `t` reduced to [0, 2 pi).
double within_loop(double t) {
  const double rest = std::fmod(t, 2 * kPi);
  return rest < 0 ? rest + 2 * kPi : rest;
}

/// For lengths scaled to R + w = 1 and q not zero.
Clearance congruent_clearance(const std::vector<Curve>& components) {
  const Curve& first = components.front();
  const Bend bend = sharpest_bend(first);
  const PairedLink link = paired_link(components, kPi / bend.curvature);
  const double resolution = 1e-15 * (std::abs(first.p) + std::abs(first.q));
  const LinkPair pair = closest_pair(link, {0, 0, bend.t, bend.t, 2 / bend.curvature}, resolution);
  const bool bends = pair.distance == 2 / bend.curvature;
  return {pair.distance > resolution ? pair.distance / 2 : 0,
          bends,
          pair.component_a,
          pair.component_b,
          within_loop(pair.t_a),
          within_loop(pair.t_b)};
}

}  // namespace

Clearance clearance(const std::vector<Curve>& link) {
  assert(!link.empty());
  const double size = link.front().major_radius + link.front().minor_radius;
  std::vector<Curve> scaled = link;
  for (Curve& curve : scaled) {
    curve.major_radius /= size;
    curve.minor_radius /= size;
  }
  Clearance found = link.front().q == 0 ? coaxial_clearance(scaled) : congruent_clearance(scaled);
  found.radius *= size;
  return found;
}

}  // namespace lumaknot
