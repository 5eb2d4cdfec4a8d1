/// Bounds of the rounded result of a recorded formula, by interval arithmetic: each step widened by
/// its rounding. Wider than rounding_bound.h, whose slopes know how steps depend on each other, but
/// it holds at every edge: where a maximum, a choice or an absolute value may fall to the other
/// side, where a vector is too short to have a direction, at powers of zero.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/shaders/graph/rounding_bound.h"

namespace lumaknot::testing {

/// The numbers from `low` to `high`.
struct Range {
  double low = 0, high = 0;
};

/// One interval per component; a scalar's is the first.
using Box = std::array<Range, 3>;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline double max_of(const Range& r) { return std::max(std::abs(r.low), std::abs(r.high)); }
inline Range hull(const Range& a, const Range& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}
inline Range widened(const Range& r, double by) { return {r.low - by, r.high + by}; }
inline Range rounded(const Range& r, double relative) { return widened(r, max_of(r) * relative); }
inline Range sum(const Range& a, const Range& b) { return {a.low + b.low, a.high + b.high}; }
inline Range negative(const Range& r) { return {-r.high, -r.low}; }
inline Range product(const Range& a, const Range& b) {
  const auto [low, high] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}
inline Range square(const Range& r) {
  const double min = r.low > 0 ? r.low : r.high < 0 ? r.high : 0;
  return {min * min, max_of(r) * max_of(r)};
}
inline Range quotient(const Range& a, const Range& b) {
  if (b.low <= 0 && b.high >= 0) return {-kInfinity, kInfinity};
  return product(a, {1 / b.high, 1 / b.low});
}

/// `f` is monotone, `error(x)` its relative error.
template <class F, class E>
Range monotone(const Range& x, F f, E error) {
  return hull(rounded({f(x.low), f(x.low)}, error(x.low)),
              rounded({f(x.high), f(x.high)}, error(x.high)));
}

/// Monotone in the base and in the exponent.
template <class Errors>
Range power_range(const Range& base, const Range& exponent) {
  Range result{kInfinity, -kInfinity};
  for (const double b : {std::max(base.low, 0.0), std::max(base.high, 0.0)}) {
    for (const double e : {exponent.low, exponent.high}) {
      const double value = std::pow(b, e);
      result = hull(result, rounded({value, value}, b > 0 ? Errors::power(b, e) : 0));
    }
  }
  return result;
}

/// Component `i` of the unit vector: x / sqrt(x^2 + y^2 + z^2) grows with x and, in size, as y and
/// z shrink.
inline Range unit_component(const Box& v, std::size_t i) {
  const Range a = square(v[(i + 1) % 3]), b = square(v[(i + 2) % 3]);
  const Range others = sum(a, b);
  const auto at = [](double x, double rest) { return x == 0 ? 0 : x / std::sqrt(x * x + rest); };
  return {at(v[i].low, v[i].low > 0 ? others.high : others.low),
          at(v[i].high, v[i].high > 0 ? others.low : others.high)};
}

template <class Errors>
Box unit_box(const Box& v) {
  const double error = 1.5 * Errors::kRounding + Errors::root() + Errors::division();
  Box result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = rounded(unit_component(v, i), error);
  return result;
}

template <class Errors>
Range dot_range(const Box& a, const Box& b, bool same) {
  Range total{};
  double sizes = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Range term = same ? square(a[i]) : product(a[i], b[i]);
    total = sum(total, term);
    sizes += max_of(term);
  }
  return widened(total, 3 * Errors::kRounding * sizes);
}

template <class Errors>
Box cross_box(const Box& a, const Box& b) {
  Box result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Range p = product(a[j], b[k]), q = product(a[k], b[j]);
    result[i] = widened(sum(p, negative(q)), 2 * Errors::kRounding * (max_of(p) + max_of(q)));
  }
  return result;
}

template <class F>
Box each(const Box& a, const Box& b, F f) {
  return {f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])};
}

inline Box point_box(const Vec3d& v) { return {Range{v.x, v.x}, Range{v.y, v.y}, Range{v.z, v.z}}; }

/// The box of `node` from its arguments' `a`.
template <class Errors>
Box box_of(const Node& node, const std::vector<Box>& a, const rounding::Inputs& inputs) {
  const auto both = [&](auto f) { return each(a[0], a[1], f); };
  const auto scalar = [](const Range& r) { return Box{r, Range{}, Range{}}; };
  const bool same = node.arguments.size() == 2 && node.arguments[0] == node.arguments[1];
  switch (node.op) {
    case Op::kInput:
      return point_box(inputs.at(node.name));
    case Op::kParameter:
      if (inputs.contains(node.name)) return point_box(inputs.at(node.name));
      [[fallthrough]];
    case Op::kConstant: {
      const Vec3d single{float(node.value.x), float(node.value.y), float(node.value.z)};
      return each(point_box(node.value), point_box(single), hull);
    }
    case Op::kAdd:
      return both([](auto x, auto y) { return rounded(sum(x, y), Errors::kRounding); });
    case Op::kSubtract:
      return both([](auto x, auto y) { return rounded(sum(x, negative(y)), Errors::kRounding); });
    case Op::kMultiply:
      return both([&](auto x, auto y) {
        return rounded(same ? square(x) : product(x, y), Errors::kRounding);
      });
    case Op::kMaximum:
      return both(
          [](auto x, auto y) { return Range{std::max(x.low, y.low), std::max(x.high, y.high)}; });
    case Op::kMinimum:
      return both(
          [](auto x, auto y) { return Range{std::min(x.low, y.low), std::min(x.high, y.high)}; });
    case Op::kSaturate:
      return each(a[0], a[0], [](auto x, auto) {
        return Range{std::clamp(x.low, 0.0, 1.0), std::clamp(x.high, 0.0, 1.0)};
      });
    case Op::kDivide:
      return scalar(rounded(quotient(a[0][0], a[1][0]), Errors::division()));
    case Op::kPower:
      return scalar(power_range<Errors>(a[0][0], a[1][0]));
    case Op::kExp:
      return scalar(monotone(a[0][0], [](double x) { return std::exp(x); }, Errors::exponential));
    case Op::kLog:
      return scalar({std::log(a[0][0].low) - Errors::logarithm(a[0][0].low),
                     std::log(a[0][0].high) + Errors::logarithm(a[0][0].high)});
    case Op::kSqrt:
      return scalar(monotone(
          a[0][0], [](double x) { return std::sqrt(std::max(x, 0.0)); },
          [](double) { return Errors::root(); }));
    case Op::kAbs: {
      const Range& r = a[0][0];
      return scalar(r.low > 0 ? r : r.high < 0 ? negative(r) : Range{0, max_of(r)});
    }
    case Op::kSelectLess:
      if (a[0][0].high < a[1][0].low) return a[2];
      return a[0][0].low >= a[1][0].high ? a[3] : each(a[2], a[3], hull);
    case Op::kScale:
      return each(a[0], a[0],
                  [&](auto x, auto) { return rounded(product(x, a[1][0]), Errors::kRounding); });
    case Op::kDot:
      return scalar(dot_range<Errors>(a[0], a[1], same));
    case Op::kCross:
      return cross_box<Errors>(a[0], a[1]);
    case Op::kUnit:
      return unit_box<Errors>(a[0]);
    case Op::kCombine:
      return {a[0][0], a[1][0], a[2][0]};
    case Op::kGrey:
      return {a[0][0], a[0][0], a[0][0]};
    case Op::kX:
      return scalar(a[0][0]);
    case Op::kY:
      return scalar(a[0][1]);
    case Op::kZ:
      return scalar(a[0][2]);
  }
  return {};
}

/// The box of the formula's result.
template <class Errors>
Box enclosure(const rounding::Tape& tape, const rounding::Inputs& inputs) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < tape.nodes.size(); ++i) {
    std::vector<Box> a;
    for (const std::size_t argument : tape.arguments[i]) a.push_back(boxes[argument]);
    boxes.push_back(box_of<Errors>(*tape.nodes[i], a, inputs));
  }
  return boxes.back();
}

/// Whether `v` is in `box`.
inline bool is_in(const Vec3d& v, const Box& box) {
  const auto in = [](double x, const Range& r) { return x >= r.low && x <= r.high; };
  return in(v.x, box[0]) && in(v.y, box[1]) && in(v.z, box[2]);
}

}  // namespace lumaknot::testing
