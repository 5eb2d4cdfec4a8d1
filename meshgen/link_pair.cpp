#include "meshgen/link_pair.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/angle.h"

namespace lumaknot {
namespace {

CurvePoint point(const PairedLink& link, int component, double t) {
  return curve_point(link.components[std::size_t(component)], t);
}

/// The pair after a Newton step on half the squared distance, the diagonal of its Hessian enlarged
/// by `damping` times the squared speeds; the pair itself where the Hessian is not positive
/// definite.
LinkPair newton_step(const PairedLink& link, LinkPair pair, double damping) {
  const CurvePoint a = point(link, pair.component_a, pair.t_a);
  const CurvePoint b = point(link, pair.component_b, pair.t_b);
  const Vec3d chord = a.position - b.position;
  const double slope_a = dot(chord, a.first), slope_b = -dot(chord, b.first);
  const double mixed = -dot(a.first, b.first);
  const double second_a = dot(a.first, a.first) * (1 + damping) + dot(chord, a.second);
  const double second_b = dot(b.first, b.first) * (1 + damping) - dot(chord, b.second);
  const double determinant = second_a * second_b - mixed * mixed;
  if (!(second_a > 0 && determinant > 0)) return pair;
  pair.t_a -= (second_b * slope_a - mixed * slope_b) / determinant;
  pair.t_b -= (second_a * slope_b - mixed * slope_a) / determinant;
  return measured(link, pair);
}

}  // namespace

PairedLink paired_link(const std::vector<Curve>& components, double near) {
  Curve curve = components.front();
  curve.meridian = 0;
  PeriodicIntegral integral([curve](double psi) { return speed(curve, psi / curve.q); });
  const double length = integral(kTurn);
  return {components, std::move(integral), length, near};
}

double arc_between(const PairedLink& link, double psi_a, double psi_b) {
  return (link.speed(psi_b) - link.speed(psi_a)) / link.components.front().q;
}

LinkPair measured(const PairedLink& link, LinkPair pair) {
  pair.distance = length(point(link, pair.component_a, pair.t_a).position -
                         point(link, pair.component_b, pair.t_b).position);
  return pair;
}

bool is_apart(const PairedLink& link, const LinkPair& pair) {
  if (pair.component_a != pair.component_b) return true;
  const Curve& curve = link.components.front();
  const double arc =
      arc_between(link, curve.q * pair.t_a + curve.meridian, curve.q * pair.t_b + curve.meridian);
  return std::abs(std::remainder(arc, link.length)) >= link.near;
}

LinkPair settled(const PairedLink& link, LinkPair pair) {
  constexpr int kSteps = 60;
  double damping = 0;
  for (int i = 0; i < kSteps; ++i) {
    const LinkPair next = newton_step(link, pair, damping);
    const double shift = std::abs(next.t_a - pair.t_a) + std::abs(next.t_b - pair.t_b);
    // At the minimum the distance rises by rounding while the parameters still improve.
    if (shift > 0 && next.distance <= pair.distance * (1 + 1e-15) && is_apart(link, next)) {
      if (damping == 0 && shift < 1e-15) return next;
      pair = next;
      damping = damping > 1e-6 ? damping / 10 : 0;
    } else {
      damping = std::max(10 * damping, 1e-4);
    }
  }
  return pair;
}

}  // namespace lumaknot
