// Ear clipping: G. H. Meisters, "Polygons have ears", 1975. An ear remains one until a neighbour is
// cut off, so each cut requires rechecking two corners: ElGindy, Everett and Toussaint, 1993.
#include "exporters/mesh/triangulate.h"

#include <algorithm>
#include <deque>

namespace lumaknot {
namespace {

/// Lengths are scaled to 1, so this is about a thousand roundings of an area.
constexpr double kNoArea = 1e-12;

using Triangle3 = std::array<std::uint32_t, 3>;

/// Relative to the first corner, with a largest component of 1, so that no product overflows or
/// underflows.
std::vector<Vec3d> scaled(std::span<const Vec3d> corners) {
  double max = 0;
  for (const Vec3d& corner : corners) {
    for (const double c : components(corner - corners[0])) max = std::max(max, std::abs(c));
  }
  std::vector<Vec3d> result;
  result.reserve(corners.size());
  for (const Vec3d& corner : corners) {
    result.push_back(max > 0 ? (corner - corners[0]) / max : Vec3d{});
  }
  return result;
}

/// Twice the area, along the normal: I. Sutherland, R. Sproull, R. Schumacker, 1974, after Newell.
Vec3d newell(std::span<const Vec3d> corners) {
  Vec3d sum;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum = sum + cross(corners[i], corners[(i + 1) % corners.size()]);
  }
  return sum;
}

bool is_convex_about(std::span<const Vec3d> corners, const Vec3d& normal) {
  const std::size_t size = corners.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Vec3d &a = corners[i], &b = corners[(i + 1) % size], &c = corners[(i + 2) % size];
    if (dot(cross(b - a, c - b), normal) <= 0) return false;
  }
  return true;
}

std::vector<Triangle3> fan(std::size_t size) {
  std::vector<Triangle3> triangles;
  triangles.reserve(size - 2);
  for (std::uint32_t i = 1; i + 1 < size; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

/// A polygon in its plane, whose corners are cut off one by one.
class EarClipper {
 public:
  EarClipper(std::span<const Vec3d> corners, const Vec3d& normal) : left_(corners.size()) {
    const Vec3d n = normalize(normal);
    const Vec3d aside = std::abs(n.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d u = normalize(cross(aside, n)), v = cross(n, u);
    for (const Vec3d& corner : corners) points_.push_back({dot(corner, u), dot(corner, v)});
    for (std::uint32_t i = 0; i < left_; ++i) {
      next_.push_back(i + 1 < left_ ? i + 1 : 0);
      previous_.push_back(i > 0 ? i - 1 : std::uint32_t(left_) - 1);
      is_cut_.push_back(false);
    }
    for (std::uint32_t i = 0; i < left_; ++i) {
      if (turn(i) <= kNoArea) blunt_.push_back(i);
    }
  }

  std::vector<Triangle3> take() {
    std::deque<std::uint32_t> todo;
    for (std::uint32_t i = 0; i < points_.size(); ++i) todo.push_back(i);
    while (left_ > 3) {
      if (todo.empty()) {
        todo = neighbours_of_cut(some_corner());
        continue;
      }
      const std::uint32_t i = todo.front();
      todo.pop_front();
      if (is_cut_[i] || !is_ear(i)) continue;
      for (const std::uint32_t neighbour : neighbours_of_cut(i)) todo.push_back(neighbour);
    }
    const std::uint32_t last = first_left();
    triangles_.push_back({previous_[last], last, next_[last]});
    return std::move(triangles_);
  }

 private:
  /// Twice the area of a, b, c: positive when they turn to the left.
  double area(const Vec2d& a, const Vec2d& b, const Vec2d& c) const {
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
  }

  double turn(std::uint32_t i) const {
    return area(points_[previous_[i]], points_[i], points_[next_[i]]);
  }

  bool is_ear(std::uint32_t i) const {
    if (turn(i) <= kNoArea) return false;
    const Vec2d &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
    return std::ranges::none_of(blunt_, [&](std::uint32_t other) {
      if (is_cut_[other]) return false;
      const Vec2d& p = points_[other];
      // Where the polygon touches itself, its corners do not block each other.
      if (p == a || p == b || p == c) return false;
      return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
    });
  }

  std::uint32_t first_left() const {
    return std::uint32_t(std::ranges::find(is_cut_, false) - is_cut_.begin());
  }

  /// The corner to cut where there is no ear: one that spans no area, else the one with the
  /// smallest.
  std::uint32_t some_corner() const {
    std::uint32_t best = first_left();
    for (std::uint32_t i = best; i < points_.size(); ++i) {
      if (!is_cut_[i] && std::abs(turn(i)) < std::abs(turn(best))) best = i;
    }
    return best;
  }

  /// Cuts off a corner and returns its two neighbours.
  std::deque<std::uint32_t> neighbours_of_cut(std::uint32_t i) {
    const std::uint32_t before = previous_[i], after = next_[i];
    triangles_.push_back({before, i, after});
    is_cut_[i] = true;
    next_[before] = after;
    previous_[after] = before;
    --left_;
    return {before, after};
  }

  std::size_t left_;
  std::vector<Vec2d> points_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<bool> is_cut_;
  std::vector<std::uint32_t> blunt_;  ///< corners that turn right or not at all: they block ears
  std::vector<Triangle3> triangles_;
};

}  // namespace

bool is_convex(std::span<const Vec3d> corners) {
  const std::vector<Vec3d> points = scaled(corners);
  return is_convex_about(points, newell(points));
}

std::vector<Triangle3> triangulate(std::span<const Vec3d> corners) {
  if (corners.size() == 3) return fan(3);
  const std::vector<Vec3d> points = scaled(corners);
  const Vec3d normal = newell(points);
  if (is_convex_about(points, normal) || length(normal) <= kNoArea) return fan(corners.size());
  return EarClipper(points, normal).take();
}

}  // namespace lumaknot
