#include "render/exact/tube_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "meshgen/sharpest_bend.h"

namespace lumaknot::exact {
namespace {

using Segment = TubeRays::Segment;

constexpr int kPiecesPerTurn = 32;
// A ray that passes the tube's surface within this, relative to the lengths involved and as a
// difference of squares, touches it: its points would not be known to 1e-10.
constexpr double kTouch = 1e-11;
constexpr double kRounding = 1e-15;  // rounding error of D, in the same measure
constexpr double kShortest = 1e-9;   // radians: shorter intervals are left undecided

/// A bound of |C''''| for all t.
double fourth_bound(const Curve& c) {
  const double p = std::abs(c.p), q = std::abs(c.q);
  return c.major_radius * std::pow(p, 4) + c.minor_radius * (std::pow(p + q, 4) + std::pow(q, 4));
}

Segment make_piece(std::size_t index, const Curve& curve, double from, double to,
                   const CurvePoint& start, const CurvePoint& end) {
  Segment piece{index, from, to, start, curve_point(curve, (from + to) / 2), end};
  const double h = piece.half();
  piece.third = length(piece.middle.third) + h * fourth_bound(curve);
  piece.second = length(piece.middle.second) + h * piece.third;
  piece.first = length(piece.middle.first) + h * piece.second;
  return piece;
}

/// A ray's line relative to a point of the curve.
struct Glance {
  double foot = 0;     ///< of the point, along the line
  Vec3d away;          ///< from the foot to the point
  double inside = 0;   ///< D
  double slope = 0;    ///< D'
  double advance = 0;  ///< d.C'
};

/// Which of a ball's two points on a line: the sign of its offset from the foot.
constexpr double kEntry = -1, kExit = 1;

/// An interval of numbers.
struct Between {
  double low, high;
  bool positive() const { return low > 0; }
  bool negative() const { return high < 0; }
  bool has_sign() const { return positive() || negative(); }

  friend Between operator+(const Between& a, const Between& b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend Between operator-(const Between& a, const Between& b) {
    return {a.low - b.high, a.high - b.low};
  }
  friend Between operator*(const Between& a, const Between& b) {
    const double products[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    const auto [min, max] = std::ranges::minmax(products);
    return {min, max};
  }
};

Between around(double middle, double spread) { return {middle - spread, middle + spread}; }

/// The root in (low, high) of a function that rises or falls there, as `rising` says: Newton's
/// method, with bisection where it leaves the interval or is slow. `function` gives the value and
/// its derivative.
template <class Function>
double root_of(const Function& function, double low, double high, bool rising) {
  double t = (low + high) / 2, last = high - low;
  for (int i = 0; i < 200; ++i) {
    const auto [value, derivative] = function(t);
    ((value < 0) == rising ? low : high) = t;
    double next = t - value / derivative;
    if (!(next > low && next < high && std::abs(next - t) < last / 2)) next = (low + high) / 2;
    last = std::abs(next - t);
    if (next == t || last <= 1e-16 * std::abs(t)) return next;
    t = next;
  }
  return t;
}

struct ValueAndSlope {
  double value, derivative;
};

}  // namespace

/// One ray's search through the pieces.
class TubeRays::Search {
 public:
  Search(const TubeRays& tube, const Ray& ray, double beyond, bool first_only)
      : tube_(tube),
        scale_(length(ray.direction)),
        origin_(ray.origin),
        direction_(ray.direction / scale_),
        radius_(tube.radius_),
        beyond_(beyond * scale_),
        first_only_(first_only) {}

  void visit(std::size_t index) {
    const Ball& ball = tube_.balls_[index];
    if (!may_meet(ball)) return;
    if (ball.last - ball.first == 1) return solve(tube_.pieces_[ball.first]);
    const std::size_t left = ball.left, right = left + 1;
    const bool swapped = foot_of(tube_.balls_[right].center) < foot_of(tube_.balls_[left].center);
    visit(swapped ? right : left);
    visit(swapped ? left : right);
  }

  TubeHits result() {
    std::ranges::sort(hits_, {}, &TubeHit::distance);
    return {std::move(hits_), doubt_ == std::numeric_limits<double>::infinity()};
  }
  FirstHit first_result() const {
    FirstHit found{std::nullopt,
                   doubt_ == std::numeric_limits<double>::infinity() || doubt_ > nearest_};
    if (!hits_.empty()) found.hit = hits_.front();
    return found;
  }

 private:
  double foot_of(const Vec3d& point) const { return dot(point - origin_, direction_); }

  bool may_meet(const Ball& ball) const {
    const Vec3d to_center = ball.center - origin_;
    const double foot = dot(to_center, direction_), reach = ball.radius + radius_;
    const Vec3d away = to_center - direction_ * foot;
    return dot(away, away) <= reach * reach * (1 + 1e-12) && foot + reach >= beyond_ &&
           foot - reach <= nearest_;
  }

  Glance glance(const CurvePoint& point) const {
    Glance g;
    const Vec3d to_point = point.position - origin_;
    g.foot = dot(to_point, direction_);
    g.away = to_point - direction_ * g.foot;
    g.inside = radius_ * radius_ - dot(g.away, g.away);
    g.slope = -2 * dot(g.away, point.first);
    g.advance = dot(direction_, point.first);
    return g;
  }
  Glance glance(std::size_t curve, double t) const {
    return glance(curve_point(tube_.curves_[curve], t));
  }

  /// D'' there.
  double bend(const Glance& g, const CurvePoint& point) const {
    return -2 * (dot(point.first, point.first) - g.advance * g.advance + dot(g.away, point.second));
  }

  /// F. Where D < 0 it has the sign of D', which is its sign at the near end of the interval D > 0.
  static double stationary(const Glance& g, double side) {
    return g.slope / 2 + side * g.advance * std::sqrt(std::max(g.inside, 0.0));
  }

  /// A bound of D's error, `part` relative to the lengths involved.
  double doubtful(const Glance& g, double part) const {
    const double away = length(g.away);
    return part * (std::abs(g.foot) + away + radius_) * (away + radius_);
  }

  // The cases of one interval: D < 0; D > 0; D'' of one sign, so that D rises, falls, or has one
  // extreme; otherwise it is halved.
  void solve(const Segment& piece) {
    const double h = piece.half();
    const Glance start = glance(piece.start), middle = glance(piece.middle),
                 end = glance(piece.end);
    const double away = length(middle.away) + h * piece.first;
    const Between bending = around(bend(middle, piece.middle),
                                   h * (6 * piece.first * piece.second + 2 * away * piece.third));
    const Between inside{
        middle.inside - h * std::abs(middle.slope) + h * h / 2 * std::min(bending.low, 0.0),
        middle.inside + h * std::abs(middle.slope) + h * h / 2 * std::max(bending.high, 0.0)};
    const double rounding = doubtful(middle, kRounding);
    if (inside.high < -rounding) return;
    if (!within_range(middle, inside, h * piece.first)) return;
    const bool within = inside.low > rounding;
    if ((within || bending.has_sign()) && one_root_at_most(piece, middle, inside, bending, away)) {
      if (within) return roots_between(piece.curve, piece.from, start, piece.to, end);
      return split_at_extreme(piece, start, end, bending.negative());
    }
    if (h < kShortest) return leave(middle);
    halve(piece);
  }

  /// Whether points of the interval may lie in the range searched.
  bool within_range(const Glance& middle, const Between& inside, double spread) const {
    const double reach = std::sqrt(std::max(inside.high, 0.0)) + spread;
    return middle.foot + reach >= beyond_ && middle.foot - reach <= nearest_;
  }

  /// Whether, for entry and for exit, F has no root in the interval or F' has one sign throughout.
  bool one_root_at_most(const Segment& piece, const Glance& middle, const Between& inside,
                        const Between& bending, double away) const {
    if (piece.thin) return true;
    const CurvePoint& at = piece.middle;
    const double h = piece.half();
    const double min = std::sqrt(std::max(inside.low, 0.0)),
                 max = std::sqrt(std::max(inside.high, 0.0));
    const Between slope = around(middle.slope / 2, h / 2 * std::max(-bending.low, bending.high));
    const Between advance = around(middle.advance, h * piece.second);
    const Between plain = around(dot(at.first, at.first) + dot(middle.away, at.second),
                                 h * (3 * piece.first * piece.second + away * piece.third));
    const Between turning = around(dot(direction_, at.second), h * piece.third);
    const auto decided = [&](const Between& shift) {  // -+ sqrt(D) lies within
      return (slope + shift * advance).has_sign() || (plain - shift * turning).has_sign();
    };
    return decided({-max, -min}) && decided({min, max});
  }

  void split_at_extreme(const Segment& piece, const Glance& start, const Glance& end,
                        bool concave) {
    const bool rises = start.slope >= 0, rises_later = end.slope >= 0;
    if (rises == rises_later) return monotone(piece.curve, piece.from, start, piece.to, end, rises);
    const Curve& curve = tube_.curves_[piece.curve];
    const auto slope = [&](double t) {
      const CurvePoint point = curve_point(curve, t);
      const Glance g = glance(point);
      return ValueAndSlope{g.slope, bend(g, point)};
    };
    const double extreme = root_of(slope, piece.from, piece.to, !concave);
    const Glance there = glance(piece.curve, extreme);
    if (std::abs(there.inside) <= doubtful(there, kTouch)) leave(there);
    monotone(piece.curve, piece.from, start, extreme, there, rises);
    monotone(piece.curve, extreme, there, piece.to, end, rises_later);
  }

  /// The roots where D rises or falls from `from` to `to`: where D < 0 begins or ends, F is D' / 2.
  void monotone(std::size_t curve, double from, const Glance& start, double to, const Glance& end,
                bool rising) {
    if ((rising ? end : start).inside <= 0) return;
    for (const double side : {kEntry, kExit}) {
      const bool before = start.inside > 0 ? stationary(start, side) >= 0 : true;
      const bool after = end.inside > 0 ? stationary(end, side) >= 0 : false;
      if (before != after) add_root(curve, from, to, side, after);
    }
  }

  /// The roots where D > 0 throughout.
  void roots_between(std::size_t curve, double from, const Glance& start, double to,
                     const Glance& end) {
    for (const double side : {kEntry, kExit}) {
      const bool before = stationary(start, side) >= 0, after = stationary(end, side) >= 0;
      if (before != after) add_root(curve, from, to, side, after);
    }
  }

  void add_root(std::size_t curve, double from, double to, double side, bool rising) {
    const auto function = [&](double t) {
      const CurvePoint point = curve_point(tube_.curves_[curve], t);
      const Glance g = glance(point);
      const double root = std::sqrt(std::max(g.inside, 0.0));
      double derivative = bend(g, point) / 2;
      if (root > 0) {
        derivative +=
            side * (dot(direction_, point.second) * root + g.advance * g.slope / (2 * root));
      }
      return ValueAndSlope{stationary(g, side), derivative};
    };
    add_hit(curve, root_of(function, from, to, rising), side);
  }

  void add_hit(std::size_t curve, double t, double side) {
    const CurvePoint point = curve_point(tube_.curves_[curve], t);
    const Glance g = glance(point);
    const double shift = side * std::sqrt(std::max(g.inside, 0.0)), along = g.foot + shift;
    if (along <= beyond_ || (first_only_ && along >= nearest_)) return;
    const Vec3d normal = normalize(direction_ * shift - g.away);
    if (first_only_) hits_.clear(), nearest_ = along;
    hits_.push_back({along / scale_, curve, t, point.position + normal * radius_, normal});
  }

  void halve(const Segment& piece) {
    const Curve& curve = tube_.curves_[piece.curve];
    const double middle = (piece.from + piece.to) / 2;
    Segment halves[] = {
        make_piece(piece.curve, curve, piece.from, middle, piece.start, piece.middle),
        make_piece(piece.curve, curve, middle, piece.to, piece.middle, piece.end)};
    for (Segment& half : halves) {
      half.thin = piece.thin;
      solve(half);
    }
  }

  void leave(const Glance& g) {
    if (g.foot > beyond_) doubt_ = std::min(doubt_, g.foot);
  }

  const TubeRays& tube_;
  double scale_;
  Vec3d origin_, direction_;
  double radius_, beyond_;
  bool first_only_;
  double nearest_ = std::numeric_limits<double>::infinity();
  double doubt_ = std::numeric_limits<double>::infinity();  // where the first undecided is
  std::vector<TubeHit> hits_;
};

TubeRays::TubeRays(std::span<const Curve> curves, double radius)
    : curves_(curves.begin(), curves.end()), radius_(radius) {
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const Curve& curve = curves_[k];
    const bool thin = sharpest_bend(curve).curvature * radius < 1 - 1e-9;
    const int count = kPiecesPerTurn * (std::abs(curve.p) + std::abs(curve.q));
    const CurvePoint first = curve_point(curve, 0);
    CurvePoint start = first;
    for (int i = 0; i < count; ++i) {
      const double to = ring_parameter(i + 1, count);
      // The last ends where the first began, to the bit.
      const CurvePoint end = i + 1 < count ? curve_point(curve, to) : first;
      pieces_.push_back(make_piece(k, curve, ring_parameter(i, count), to, start, end));
      pieces_.back().thin = thin;
      start = end;
    }
  }
  balls_.emplace_back();
  fill(0, 0, pieces_.size());
}

void TubeRays::fill(std::size_t ball, std::size_t first, std::size_t last) {
  if (last - first == 1) {
    const Segment& piece = pieces_[first];
    balls_[ball] = {piece.middle.position, piece.half() * piece.first, first, last, 0};
    return;
  }
  const std::size_t left = balls_.size(), half = first + (last - first) / 2;
  balls_.resize(left + 2);
  fill(left, first, half);
  fill(left + 1, half, last);
  const Ball &a = balls_[left], &b = balls_[left + 1];
  const Vec3d center = (a.center + b.center) / 2.0;
  const double radius =
      std::max(length(a.center - center) + a.radius, length(b.center - center) + b.radius);
  balls_[ball] = {center, radius, first, last, left};
}

TubeHits TubeRays::all(const Ray& ray) const {
  Search search(*this, ray, -std::numeric_limits<double>::infinity(), false);
  search.visit(0);
  return search.result();
}

FirstHit TubeRays::first(const Ray& ray, double beyond) const {
  Search search(*this, ray, beyond, true);
  search.visit(0);
  return search.first_result();
}

}  // namespace lumaknot::exact
