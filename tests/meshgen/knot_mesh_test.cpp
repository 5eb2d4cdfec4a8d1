#include "meshgen/knot_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "math/angle.h"
#include "meshgen/closed_mesh.h"
#include "meshgen/knot_mesh.h"
#include "meshgen/measure.h"
#include "system/error.h"

namespace lumaknot {
namespace {

KnotSpec knot_of(int p, int q, int segments, int sides) {
  KnotSpec knot;
  knot.p = p;
  knot.q = q;
  knot.segments = segments;
  knot.sides = sides;
  return knot;
}

ClosedMesh closed(const KnotSpec& knot) { return closed_mesh(knot, knot_mesh(knot)); }

/// Pappus: a tube's cross-section times the path length of its centre.
double pappus_volume(const KnotSpec& knot) {
  double length = 0;
  for (const Curve& line : components(knot)) length += Spine(line).length();
  return kPi * knot.tube_radius * knot.tube_radius * length;
}

TEST(KnotMesh, trefoil_tube_is_closed_with_genus_one) {
  const ClosedMesh mesh = closed(KnotSpec{});
  const std::vector<ConnectedComponent> all = connected_components(mesh);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].euler_characteristic(), 0);
  EXPECT_EQ(all[0].genus(), 1);
  EXPECT_EQ(all[0].boundary_edges, 0);
  EXPECT_EQ(mesh.n_vertices(), 768u * 40u);
  EXPECT_EQ(mesh.n_faces(), 61'440u);
}

TEST(KnotMesh, every_knot_and_link_is_closed_with_genus_one_per_component) {
  for (int p = -6; p <= 6; ++p) {
    for (int q = -6; q <= 6; ++q) {
      if (p == 0 && q == 0) continue;
      for (const auto& [segments, sides] : {std::pair{3, 3}, {4, 7}, {60, 5}}) {
        const std::vector<ConnectedComponent> all =
            connected_components(closed(knot_of(p, q, segments, sides)));
        ASSERT_EQ(all.size(), std::size_t(std::gcd(p, q))) << p << "," << q;
        for (const ConnectedComponent& piece : all) {
          ASSERT_EQ(piece.faces, 2 * segments * sides) << p << "," << q;
          ASSERT_EQ(piece.euler_characteristic(), 0) << p << "," << q;
          ASSERT_EQ(piece.genus(), 1) << p << "," << q;
          ASSERT_EQ(piece.boundary_edges, 0) << p << "," << q;
        }
      }
    }
  }
}

TEST(KnotMesh, no_triangle_is_degenerate) {
  const ClosedMesh mesh = closed(knot_of(2, 3, 200, 12));
  for (const auto face : mesh.faces()) ASSERT_GT(mesh.calc_face_area(face), 1e-6);
}

TEST(KnotMesh, is_outward_and_below_pappus_volume) {
  for (const auto& [p, q] : {std::pair{2, 3}, {-2, 3}, {2, -3}, {1, 0}, {0, 1}, {4, 6}, {3, 0}}) {
    KnotSpec knot = knot_of(p, q, 300, 20);
    knot.tube_radius = 0.1;
    const double measured = volume(closed(knot));
    EXPECT_GT(measured, 0) << p << "," << q;
    EXPECT_LT(measured, pappus_volume(knot)) << p << "," << q;  // chords lie inside
  }
}

double volume_error(const KnotSpec& knot) {
  return std::abs(volume(closed(knot)) / pappus_volume(knot) - 1);
}

TEST(KnotMesh, volume_converges_to_pappus_at_order_2) {
  for (const auto& [p, q] : {std::pair{2, 3}, {5, 2}, {1, 0}, {2, 4}}) {
    const double coarse = volume_error(knot_of(p, q, 240, 12));
    const double middle = volume_error(knot_of(p, q, 480, 24));
    const double fine = volume_error(knot_of(p, q, 960, 48));
    EXPECT_NEAR(std::log2(coarse / middle), 2, 0.1) << p << "," << q;  // higher terms: h^4
    EXPECT_NEAR(std::log2(middle / fine), 2, 0.05) << p << "," << q;
    // An n-gon misses the share (2 pi / n)^2 / 6 of its circle, 0.29 % at 48; the chords along the
    // knot add less than that.
    EXPECT_LT(fine, 0.006) << p << "," << q;
  }
}

TEST(KnotMesh, every_vertex_is_one_tube_radius_from_the_centre_line_along_its_normal) {
  const KnotSpec knot = knot_of(5, 2, 100, 9);
  const Curve line = components(knot).front();
  const TriangleMesh mesh = knot_mesh(knot);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const CurvePoint centre = curve_point(line, ring_parameter(int(i) / 10, knot.segments));
    const Vec3d normal = mesh.normals[i];
    const Vec3d arm = mesh.positions[i] - centre.position;
    ASSERT_NEAR(length(normal), 1, 1e-13);  // rounding
    ASSERT_LT(length(arm - normal * knot.tube_radius), 1e-14);
    ASSERT_NEAR(dot(normal, normalize(centre.first)), 0, 1e-13);
  }
}

TEST(KnotMesh, no_part_of_the_centre_line_is_nearer_than_the_tube_radius) {
  // The default knot clears itself, so the nearest point of the line is the ring's own centre.
  const KnotSpec knot = knot_of(2, 3, 96, 8);
  const Curve line = components(knot).front();
  const TriangleMesh mesh = knot_mesh(knot);
  for (const Vec3d& vertex : mesh.positions) {
    double nearest = 1e9;
    for (int i = 0; i < 960; ++i) {
      const Vec3d centre = curve_point(line, ring_parameter(i, 960)).position;
      nearest = std::min(nearest, length(vertex - centre));
    }
    ASSERT_NEAR(nearest, knot.tube_radius, 1e-13);  // every tenth sample is a ring's centre
  }
}

TEST(KnotMesh, ring_torus_has_the_torus_s_normals) {
  // (1,0): a torus of radii R + w and tube about the axis, known in closed form.
  const KnotSpec knot = knot_of(1, 0, 50, 12);
  const TriangleMesh mesh = knot_mesh(knot);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d x = mesh.positions[i];
    const double ring = std::hypot(x.x, x.y);
    const Vec3d centre{x.x / ring * 1.4, x.y / ring * 1.4, 0};
    ASSERT_NEAR(length(x - centre), knot.tube_radius, 1e-14);
    ASSERT_LT(length(mesh.normals[i] - normalize(x - centre)), 1e-13);  // rounding
  }
}

TEST(KnotMesh, triangles_wind_counter_clockwise_about_their_vertex_normals) {
  for (const auto& [p, q] : {std::pair{2, 3}, {-2, 3}, {1, 0}, {0, -1}}) {
    ClosedMesh mesh = closed(knot_of(p, q, 200, 16));
    for (const auto face : mesh.faces()) {
      const auto flat = mesh.calc_face_normal(face);
      for (const auto vertex : mesh.fv_range(face)) ASSERT_GT(flat | mesh.normal(vertex), 0.5);
    }
  }
}

TEST(KnotMesh, is_the_same_to_the_bit_each_time) {
  const TriangleMesh a = knot_mesh(KnotSpec{}), b = knot_mesh(KnotSpec{});
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.uvs, b.uvs);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(KnotMesh, an_invalid_spec_is_refused) {
  EXPECT_THROW(knot_mesh(knot_of(0, 0, 10, 10)), Error);
  EXPECT_THROW(knot_mesh(knot_of(2, 3, 2, 10)), Error);
  EXPECT_THROW(knot_mesh(knot_of(2, 3, 10, 2)), Error);
}

}  // namespace
}  // namespace lumaknot
