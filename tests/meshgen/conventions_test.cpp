#include <gtest/gtest.h>

#include "math/angle.h"
#include "meshgen/closed_mesh.h"
#include "meshgen/knot_mesh.h"
#include "meshgen/measure.h"
#include "meshgen/surface.h"
#include "meshgen/tangents.h"
#include "scene/presets.h"

namespace lumaknot {
namespace {

Vec3d face_vector(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3d a = mesh.positions[t[0]];
  return cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

// The output of three.js and Babylon.js themselves is compared in tests/peers.

TEST(Conventions, three_cuts_quads_along_the_other_diagonal) {
  const TriangleMesh mesh = knot_mesh(knot_defaults(Convention::kThree));
  ASSERT_EQ(mesh.positions.size(), 65u * 9u);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 9, 1}));
  EXPECT_EQ(mesh.triangles[1], (Triangle{9, 10, 1}));
}

TEST(Conventions, three_retraces_what_is_a_link) {
  KnotSpec knot = knot_defaults(Convention::kThree);
  knot.p = 4;
  knot.q = 6;
  const TriangleMesh mesh = knot_mesh(knot);
  ASSERT_EQ(mesh.positions.size(), 65u * 9u);  // one loop, twice
  constexpr std::size_t kColumns = 9, kLoop = 32 * kColumns;
  for (std::size_t i = 0; i + kLoop < mesh.positions.size(); ++i) {
    EXPECT_LT(length(mesh.positions[i] - mesh.positions[i + kLoop]), 1e-13);  // rounding
  }
  knot = KnotSpec{};
  knot.p = 4;
  knot.q = 6;
  EXPECT_EQ(knot_mesh(knot).positions.size(), 2u * 769u * 41u);
}

TEST(Conventions, babylon_has_no_seam_around_and_winds_clockwise) {
  const KnotSpec knot = knot_defaults(Convention::kBabylon);
  const TriangleMesh mesh = knot_mesh(knot);
  ASSERT_EQ(mesh.positions.size(), 33u * 32u);
  for (const Triangle& t : mesh.triangles) {
    ASSERT_LT(dot(face_vector(mesh, t), mesh.normals[t[0]]), 0);
  }
  EXPECT_LT(volume(closed_mesh(knot, mesh)), 0);
  // The normals of the first ring and of the last, at the same places, differ: a seam.
  constexpr std::size_t kSides = 32, kLast = 32 * kSides;
  double max = 0;
  for (std::size_t j = 0; j < kSides; ++j) {
    max = std::max(max, length(mesh.normals[j] - mesh.normals[kLast + j]));
  }
  EXPECT_GT(max, 0.05);
}

TEST(Conventions, blender_is_the_default_tube_about_its_own_knot) {
  const KnotSpec blender = knot_defaults(Convention::kBlender);
  KnotSpec own = blender;
  own.convention = Convention::kLumaknot;
  EXPECT_EQ(knot_mesh(blender).positions, knot_mesh(own).positions);
}

TEST(Unwrap, by_arc_length_the_texture_is_nowhere_stretched_along) {
  KnotSpec knot;
  knot.segments = 400;
  knot.sides = 4;
  knot.minor_radius = 0.5;
  const auto ratio = [&] {
    const TriangleMesh mesh = knot_mesh(knot);
    const Curve line = components(knot).front();
    double min = 1e9, max = 0;
    const auto u_of = [&](int ring) { return mesh.uvs[5 * std::size_t(ring)].u; };
    for (int i = 0; i < knot.segments; ++i) {
      const double way = length(curve_point(line, ring_parameter(i + 1, 400)).position -
                                curve_point(line, ring_parameter(i, 400)).position);
      const double share = way / (u_of(i + 1) - u_of(i));
      min = std::min(min, share);
      max = std::max(max, share);
    }
    return max / min;
  };
  knot.unwrap = Unwrap::kParameter;
  EXPECT_NEAR(ratio(), 1.86, 0.005);  // sqrt(11.25 / 3.25), the known figure
  knot.unwrap = Unwrap::kArcLength;
  EXPECT_NEAR(ratio(), 1, 1e-3);  // chords for arcs: (curvature x step)^2 / 24
}

TEST(Tangents, are_the_surface_s_derivative_along_u) {
  KnotSpec knot;
  knot.segments = 600;
  knot.sides = 48;
  const TriangleMesh mesh = knot_mesh(knot);
  const Bulk<Tangent> all = tangents(mesh);
  ASSERT_EQ(all.size(), mesh.positions.size());
  const Spine spine(components(knot).front());
  for (int i = 1; i < knot.segments; i += 7) {
    for (int j = 1; j < knot.sides; ++j) {
      const std::size_t at = 49 * std::size_t(i) + std::size_t(j);
      const double t = ring_parameter(i, 600), theta = 2 * kPi * j / 48;
      const TubeSurface tube(spine, knot.tube_radius);
      const Vec3d along = normalize(tube.at(t, theta).along);
      // A vertex's triangles are half a step to each side: the error is of the step's order, 0.01,
      // times how fast the direction turns.
      ASSERT_LT(length(all[at].direction - along), 0.02) << i << "," << j;
      ASSERT_NEAR(dot(all[at].direction, mesh.normals[at]), 0, 1e-13);
      ASSERT_EQ(all[at].sign, 1);  // u, v and the normal are right-handed
    }
  }
}

TEST(Tangents, point_along_u_and_their_cross_product_along_v) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  mesh.uvs = {{0, 0}, {0, 1}, {1, 0}};  // u along +y, v along +x: mirrored
  for (const Tangent& t : tangents(mesh)) {
    EXPECT_LT(length(t.direction - Vec3d{0, 1, 0}), 1e-15);
    EXPECT_EQ(t.sign, -1);
    const Vec3d along_v = cross(Vec3d{0, 0, 1}, t.direction) * t.sign;
    EXPECT_LT(length(along_v - Vec3d{1, 0, 0}), 1e-15);
  }
}

}  // namespace
}  // namespace lumaknot
