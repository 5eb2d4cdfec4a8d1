/// Small vectors. Right-handed frames, +Z up.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace lumaknot {

/// Three components of the number type S.
template <class S>
struct Vec3 {
  S x{}, y{}, z{};

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Vec3 operator*(const Vec3& a, const S& s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator*(const S& s, const Vec3& a) { return a * s; }
  friend constexpr Vec3 operator/(const Vec3& a, const S& s) { return {a.x / s, a.y / s, a.z / s}; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend bool operator==(const Vec3&, const Vec3&) = default;  // constexpr if S's is
};

using Vec3d = Vec3<double>;

/// Texture coordinates: u to the right, v up, origin at the bottom left.
struct Vec2d {
  double u = 0, v = 0;
  friend constexpr bool operator==(const Vec2d&, const Vec2d&) = default;
};

template <class S>
constexpr S dot(const Vec3<S>& a, const Vec3<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class S>
constexpr Vec3<S> cross(const Vec3<S>& a, const Vec3<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class S>
S length(const Vec3<S>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// The unit vector along `a`, which must not be zero.
template <class S>
Vec3<S> normalize(const Vec3<S>& a) {
  return a / length(a);
}

template <class S>
constexpr std::array<S, 3> components(const Vec3<S>& a) {
  return {a.x, a.y, a.z};
}

inline double largest_component(const Vec3d& a) { return std::max({a.x, a.y, a.z}); }

/// The maximum norm.
inline double largest_magnitude(const Vec3d& a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

inline bool is_finite(const Vec3d& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace lumaknot
