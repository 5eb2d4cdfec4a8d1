#include "study/stability/region.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lumaknot::stability {

bool holds(const Region& region, double error) { return error <= region.limit; }

double at_share(const Sweep& sweep, double s) {
  if (s <= 0) return sweep.from;
  if (s >= 1) return sweep.to;
  const double x = sweep.logarithmic ? sweep.from * std::pow(sweep.to / sweep.from, s)
                                     : sweep.from + (sweep.to - sweep.from) * s;
  return sweep.whole ? std::round(x) : x;
}

std::vector<double> swept_values(const Sweep& sweep, int steps) {
  std::vector<double> values;
  for (int i = 0; i <= steps; ++i) {
    const double x = at_share(sweep, double(i) / steps);
    if (values.empty() || x != values.back()) values.push_back(x);
  }
  return values;
}

std::vector<SweepInterval> stretches(const std::vector<Measured>& sweep, double limit,
                                     bool holding) {
  std::vector<SweepInterval> all;
  bool inside = false;
  for (const Measured& m : sweep) {
    const bool before = inside;
    inside = (m.error <= limit) == holding;
    if (inside && !before) all.push_back({m.x, m.x});
    if (inside) all.back().to = m.x;
  }
  return all;
}

namespace {

/// The value half way, or one of the two if they are neighbours.
double middle(const Sweep& sweep, double a, double b) {
  if (sweep.whole) {
    const double rounded = std::floor((a + b) / 2);
    return sweep.logarithmic && rounded != a && rounded != b
               ? std::clamp(std::round(std::sqrt(a * b)), std::min(a, b) + 1, std::max(a, b) - 1)
               : rounded;
  }
  return sweep.logarithmic ? a * std::sqrt(b / a) : (a + b) / 2;
}

bool apart(const Sweep& sweep, double a, double b) {
  if (sweep.whole) return std::abs(a - b) > 1;
  const double way = sweep.logarithmic ? std::log(b / a) / std::log(sweep.to / sweep.from)
                                       : (b - a) / (sweep.to - sweep.from);
  return std::abs(way) > kBoundaryTolerance;
}

}  // namespace

Boundary find_boundary(const Region& region, const std::vector<Measured>& sweep) {
  const auto failing =
      std::ranges::find_if(sweep, [&](const Measured& m) { return !holds(region, m.error); });
  if (failing == sweep.begin() || failing == sweep.end()) {
    throw std::logic_error(region.name + ": the sweep does not go from holding to failing");
  }
  Boundary found{*(failing - 1), *failing};
  while (apart(region.sweep, found.holds.x, found.fails.x)) {
    const double x = middle(region.sweep, found.holds.x, found.fails.x);
    const Measured m{x, region.error(x)};
    (holds(region, m.error) ? found.holds : found.fails) = m;
  }
  return found;
}

}  // namespace lumaknot::stability
