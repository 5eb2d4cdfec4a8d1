#include "meshgen/deviation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <numeric>

#include "math/angle.h"
#include "meshgen/tube_distance.h"
#include "system/error.h"

namespace lumaknot {
namespace {

/// A tube with the spine that it refers to.
struct Tube {
  Spine spine;
  double radius;
  Tube(const Curve& curve, double r) : spine(curve), radius(r) {}
  TubeSurface surface() const { return {spine, radius}; }
};

Tube tube_of(int p, int q, double radius) { return {Curve{p, q}, radius}; }

/// The grid's vertices, as a mesh holds them.
struct Vertices {
  std::vector<Vec3d> positions, normals;
};

Vertices vertices_of(const TubeSurface& surface, int segments, int sides) {
  Vertices vertices;
  for (int i = 0; i <= segments; ++i) {
    for (int j = 0; j <= sides; ++j) {
      const TubePoint x = surface.at(ring_parameter(i, segments), 2 * kPi * j / sides);
      vertices.positions.push_back(x.position);
      vertices.normals.push_back(x.normal);
    }
  }
  return vertices;
}

/// The largest deviation at a lattice of points of every triangle.
double sampled_chord(const TubeSurface& surface, int segments, int sides, int lattice) {
  const std::vector<Vec3d> x = vertices_of(surface, segments, sides).positions;
  const Curve& curve = surface.spine().curve();
  double worst = 0;
  const auto sample = [&](double t, const Vec3d& point) {
    const double d = distance_near(curve, curve_point(curve, t), t, point);
    worst = std::max(worst, std::abs(d - surface.tube_radius()));
  };
  for (int quad = 0; quad < segments * sides; ++quad) {
    const int i = quad / sides, row = sides + 1, a = i * row + quad % sides, b = a + row;
    for (int k = 0; k < (lattice + 1) * (lattice + 1); ++k) {
      const int along = k / (lattice + 1), across = k % (lattice + 1);
      const double u = double(along) / lattice, v = double(across) / lattice;
      if (u + v > 1) continue;
      const auto at = [&](int n) { return x[std::size_t(n)]; };
      const double h = 2 * kPi / segments;
      sample(h * (i + u + v), at(a) * (1 - u - v) + at(b) * u + at(b + 1) * v);
      sample(h * (i + u), at(a) * (1 - u - v) + at(b + 1) * u + at(a + 1) * v);
    }
  }
  return worst;
}

/// The distance of the origin to the edge from a to b.
double distance_to_edge(const Vec2d& a, const Vec2d& b) {
  const double du = b.u - a.u, dv = b.v - a.v;
  const double s = std::clamp(-(a.u * du + a.v * dv) / (du * du + dv * dv), 0.0, 1.0);
  return std::hypot(a.u + s * du, a.v + s * dv);
}

/// A torus' quads are flat trapezoids; at a given height the deviation is largest halfway along, or
/// on the ring. So the worst is in the half plane of the segment's middle, where the trapezoids are
/// the edges of a polygon, or on the ring's own polygon.
double torus_chord(double ring, double r, int segments, int sides) {
  double worst = r * (1 - std::cos(kPi / sides));
  const auto corner = [&](int j) {
    const double theta = 2 * kPi * j / sides;
    return Vec2d{(ring + r * std::cos(theta)) * std::cos(kPi / segments) - ring,
                 r * std::sin(theta)};
  };
  for (int j = 0; j < sides; ++j) {
    const Vec2d a = corner(j), b = corner(j + 1);
    worst = std::max({worst, r - distance_to_edge(a, b), std::hypot(a.u, a.v) - r});
  }
  return worst;
}

/// Coprime p, q with a tube that neither touches itself nor exceeds the curve's radius of
/// curvature.
std::vector<Tube> fifty_tubes() {
  std::vector<Tube> tubes;
  for (int p = -6; p <= 8 && tubes.size() < 50; ++p) {
    for (int q = 0; q <= 6 && tubes.size() < 50; ++q) {
      if (std::gcd(p, q) != 1) continue;
      double sharpest = 0;
      for (int i = 0; i < 200; ++i) {
        sharpest = std::max(sharpest, curvature(curve_point({p, q}, 0.0314 * i)));
      }
      tubes.push_back(tube_of(p, q, std::min(0.4 / sharpest, 0.3 / std::max(std::abs(p), q))));
    }
  }
  return tubes;
}

TEST(Deviation, a_torus_is_off_as_geometry_says) {
  for (const auto& [segments, sides] : {std::pair{40, 24}, {24, 40}, {200, 9}, {13, 64}}) {
    const Tube about = tube_of(1, 0, 0.18), through = tube_of(0, 1, 0.1);
    // The maximisation's last steps.
    EXPECT_NEAR(measured_deviation(about.surface(), segments, sides).chord /
                    torus_chord(1.4, 0.18, segments, sides),
                1, 1e-6);
    EXPECT_NEAR(measured_deviation(through.surface(), segments, sides).chord /
                    torus_chord(0.4, 0.1, segments, sides),
                1, 1e-6);
  }
}

TEST(Deviation, is_the_largest_of_many_samples) {
  for (const Tube& tube : {tube_of(2, 3, 0.18), tube_of(3, 5, 0.05), tube_of(-7, 4, 0.03)}) {
    for (const auto& [segments, sides] : {std::pair{30, 7}, {61, 5}, {97, 12}}) {
      const double sampled = sampled_chord(tube.surface(), segments, sides, 16);
      const double measured = measured_chord(tube.surface(), segments, sides);
      EXPECT_GE(measured, sampled * (1 - 1e-6));  // the maximisation's last steps
      // The worst place is at most half a step of the lattice away, and about (1 / 16)^2 better.
      EXPECT_LE(measured, sampled * (1 + 4e-3));
    }
  }
}

TEST(Deviation, falls_to_a_quarter_when_the_steps_halve) {
  for (const Tube& tube : {tube_of(2, 3, 0.18), tube_of(5, 2, 0.1), tube_of(1, 0, 0.18)}) {
    const Deviation coarse = measured_deviation(tube.surface(), 400, 20);
    const Deviation fine = measured_deviation(tube.surface(), 800, 40);
    // The next order, and the position of the worst place between the vertices.
    EXPECT_NEAR(coarse.chord / fine.chord, 4, 0.2);
  }
}

TEST(Deviation, normals_are_off_by_the_second_order_too) {
  const Tube tube = tube_of(2, 3, 0.18);
  const double coarse = measured_deviation(tube.surface(), 1600, 80).normal_degrees;
  const double fine = measured_deviation(tube.surface(), 3200, 160).normal_degrees;
  EXPECT_NEAR(coarse / fine, 4, 0.2);  // the third order is a fortieth here
}

TEST(Deviation, the_chord_alone_is_the_same) {
  const Tube tube = tube_of(2, 3, 0.18);
  EXPECT_EQ(measured_chord(tube.surface(), 97, 12),
            measured_deviation(tube.surface(), 97, 12).chord);
}

TEST(Deviation, does_not_depend_on_the_number_of_cores) {
  const Tube tube = tube_of(3, 5, 0.05);
  const Deviation all = measured_deviation(tube.surface(), 900, 31);
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const Deviation alone = measured_deviation(tube.surface(), 900, 31);
  EXPECT_EQ(all.chord, alone.chord);
  EXPECT_EQ(all.normal_degrees, alone.normal_degrees);
}

TEST(Deviation, of_given_vertices_is_that_of_their_grid) {
  const Tube tube = tube_of(2, 3, 0.18);
  const Vertices given = vertices_of(tube.surface(), 120, 13);
  const Deviation own = measured_deviation(tube.surface(), 120, 13);
  const Deviation same =
      measured_deviation(tube.surface(), 120, 13, given.positions, given.normals);
  EXPECT_NEAR(same.chord, own.chord, 1e-14);                   // rounding of vertices near one
  EXPECT_NEAR(same.normal_degrees, own.normal_degrees, 1e-9);  // and of an angle's cosine
}

TEST(Deviation, one_vertex_pulled_out_and_one_normal_tilted_are_found) {
  const Tube tube = tube_of(2, 3, 0.18);
  Vertices given = vertices_of(tube.surface(), 300, 30);
  const std::size_t vertex = 100 * 31 + 7;
  const TubePoint x = tube.surface().at(ring_parameter(100, 300), 2 * kPi * 7 / 30);
  given.positions[vertex] = x.position + x.normal * 0.05;
  given.normals[vertex] = x.normal + normalize(x.around) * std::tan(0.1);
  const Deviation found =
      measured_deviation(tube.surface(), 300, 30, given.positions, given.normals);
  EXPECT_NEAR(found.chord, 0.05, 1e-14);  // rounding; the vertex itself is farthest
  // The triangles' own error of a few hundredths of a degree may add to it, not subtract.
  EXPECT_GE(found.normal_degrees, 0.1 * 180 / kPi * (1 - 1e-12));
  EXPECT_LE(found.normal_degrees, 0.1 * 180 / kPi + 0.1);
}

TEST(Deviation, too_few_vertices_are_an_error) {
  const Tube tube = tube_of(2, 3, 0.18);
  const Vertices given = vertices_of(tube.surface(), 12, 5);
  EXPECT_THAT([&] { measured_deviation(tube.surface(), 12, 6, given.positions, given.normals); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("has 91 positions")));
}

TEST(Deviation, stays_below_its_bound) {
  for (const Tube& tube : fifty_tubes()) {
    for (const auto& [segments, sides] : {std::pair{3, 3}, {12, 5}, {60, 8}, {100, 60}, {400, 9}}) {
      const Deviation measured = measured_deviation(tube.surface(), segments, sides);
      const Deviation bound = deviation_bound(tube.surface(), segments, sides);
      const Curve& curve = tube.spine.curve();
      // Rounding, where a circle's bound is the deviation itself.
      EXPECT_LE(measured.chord, bound.chord * (1 + 1e-9)) << curve.p << ' ' << curve.q;
      EXPECT_LE(measured.normal_degrees, bound.normal_degrees) << curve.p << ' ' << curve.q;
    }
  }
}

TEST(Deviation, points_of_triangles_are_within_the_bound_of_their_place) {
  constexpr int kSegments = 60, kSides = 9, kSteps = 4;  // steps of a triangle's edge
  for (const Tube& tube : fifty_tubes()) {
    const TubeSurface surface = tube.surface();
    const double bound = deviation_bound(surface, kSegments, kSides).offset;
    EXPECT_GE(bound, deviation_bound(surface, kSegments, kSides).chord);
    const auto at = [&](double i, double j) {
      return surface.at(2 * kPi * i / kSegments, 2 * kPi * j / kSides).position;
    };
    for (int i = 0; i < kSegments; ++i) {
      for (int j = 0; j < kSides; ++j) {
        const Vec3d a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1);
        for (int k = 0; k <= kSteps; ++k) {
          for (int l = 0; l <= k; ++l) {  // a + x (b - a) + y (c - b), y <= x
            const double x = double(k) / kSteps, y = double(l) / kSteps;
            const Vec3d flat = a + (b - a) * x + (c - b) * y;
            ASSERT_LE(length(flat - at(i + x, j + y)), bound * (1 + 1e-9) + 1e-14);
          }
        }
      }
    }
  }
}

TEST(Deviation, has_a_bound_that_is_not_far_above) {
  for (const Tube& tube : fifty_tubes()) {
    const Deviation measured = measured_deviation(tube.surface(), 768, 40);
    const Deviation bound = deviation_bound(tube.surface(), 768, 40);
    // The bound's excess is of the next order: measured at most 1.4 and 2.7 times here.
    EXPECT_LE(bound.chord, 1.5 * measured.chord) << tube.spine.curve().p << tube.spine.curve().q;
    EXPECT_LE(bound.normal_degrees, 3 * measured.normal_degrees);
  }
}

TEST(TubeDistance, is_the_smallest_distance_to_points_of_the_branch) {
  const Curve curve{2, 3};
  for (int i = 0; i < 50; ++i) {
    const double t = 0.13 * i;
    const CurvePoint at = curve_point(curve, t);
    // Points within the radius of curvature, off the parameter's own plane.
    const Vec3d x = curve_point(curve, t + 0.1).position +
                    Vec3d{std::cos(1.0 * i), std::sin(2.0 * i), std::sin(3.0 * i)} * 0.1;
    double min = 10;
    for (int k = -2000; k <= 2000; ++k) {
      min = std::min(min, length(x - curve_point(curve, t + 2.5e-4 * k).position));
    }
    const double d = distance_near(curve, at, t, x);
    EXPECT_LE(d, min * (1 + 1e-14));
    EXPECT_GE(d,
              min - 1e-5);  // samples are up to 1.25e-4 * |C'| = 4e-4 away: 4e-4^2 / (2 * 0.03)
  }
}

}  // namespace
}  // namespace lumaknot
