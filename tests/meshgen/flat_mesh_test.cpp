#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "meshgen/closed_mesh.h"
#include "meshgen/knot_mesh.h"

namespace lumaknot {
namespace {

KnotSpec small_knot() {
  KnotSpec knot;
  knot.segments = 48;
  knot.sides = 9;
  knot.repeat_u = 12;
  knot.repeat_v = 3;
  return knot;
}

std::tuple<double, double, double> key(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// Twice the signed area in the texture's plane.
double uv_area(const TriangleMesh& mesh, const Triangle& t) {
  const Vec2d a = mesh.uvs[t[0]], b = mesh.uvs[t[1]], c = mesh.uvs[t[2]];
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

TEST(FlatMesh, figure_2_has_the_paper_s_counts) {
  const TriangleMesh mesh = knot_mesh(KnotSpec{});
  EXPECT_EQ(mesh.positions.size(), 31'529u);
  EXPECT_EQ(mesh.triangles.size(), 61'440u);
}

TEST(FlatMesh, seams_are_duplicated_in_both_directions_for_every_grid) {
  for (const auto& [segments, sides] : {std::pair{3, 3}, {3, 8}, {17, 4}, {100, 10}}) {
    KnotSpec knot;
    knot.segments = segments;
    knot.sides = sides;
    const TriangleMesh mesh = knot_mesh(knot);
    EXPECT_EQ(mesh.positions.size(), std::size_t((segments + 1) * (sides + 1)));
    EXPECT_EQ(mesh.triangles.size(), std::size_t(2 * segments * sides));
  }
}

TEST(FlatMesh, arrays_have_one_length_and_every_vertex_is_used) {
  const TriangleMesh mesh = knot_mesh(small_knot());
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.uvs.size(), mesh.positions.size());
  std::set<std::uint32_t> used;
  for (const Triangle& t : mesh.triangles) used.insert(t.begin(), t.end());
  EXPECT_EQ(used.size(), mesh.positions.size());
  EXPECT_LT(*used.rbegin(), mesh.positions.size());
}

TEST(FlatMesh, vertices_come_ring_by_ring_and_side_by_side) {
  const TriangleMesh mesh = knot_mesh(small_knot());
  for (std::size_t i = 1; i < mesh.uvs.size(); ++i) {
    const Vec2d &last = mesh.uvs[i - 1], &next = mesh.uvs[i];
    ASSERT_TRUE(next.u > last.u || (next.u == last.u && next.v > last.v)) << i;
  }
}

TEST(FlatMesh, positions_and_normals_are_the_closed_mesh_s) {
  const ClosedMesh closed = closed_mesh(small_knot(), knot_mesh(small_knot()));
  std::set<std::pair<std::tuple<double, double, double>, std::tuple<double, double, double>>> known;
  for (const auto v : closed.vertices()) {
    const auto p = closed.point(v), n = closed.normal(v);
    known.insert({{p[0], p[1], p[2]}, {n[0], n[1], n[2]}});
  }
  const TriangleMesh flat = knot_mesh(small_knot());
  for (std::size_t i = 0; i < flat.positions.size(); ++i) {
    ASSERT_TRUE(known.contains({key(flat.positions[i]), key(flat.normals[i])})) << i;
  }
}

TEST(FlatMesh, triangles_are_the_closed_mesh_s_in_their_order) {
  const ClosedMesh closed = closed_mesh(small_knot(), knot_mesh(small_knot()));
  const TriangleMesh flat = knot_mesh(small_knot());
  std::size_t i = 0;
  for (const auto face : closed.faces()) {
    std::set<std::tuple<double, double, double>> expected, found;
    for (const auto v : closed.fv_range(face)) {
      expected.insert({closed.point(v)[0], closed.point(v)[1], closed.point(v)[2]});
    }
    for (const std::uint32_t index : flat.triangles[i]) found.insert(key(flat.positions[index]));
    ASSERT_EQ(found, expected) << i;
    ++i;
  }
}

TEST(FlatMesh, no_two_vertices_share_position_and_texture_coordinate) {
  const TriangleMesh mesh = knot_mesh(small_knot());
  std::set<std::pair<std::tuple<double, double, double>, std::pair<double, double>>> seen;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_TRUE(seen.insert({key(mesh.positions[i]), {mesh.uvs[i].u, mesh.uvs[i].v}}).second) << i;
  }
}

TEST(FlatMesh, texture_coordinates_run_from_zero_to_the_repeats_exactly) {
  const TriangleMesh mesh = knot_mesh(small_knot());
  const auto [min_u, max_u] = std::ranges::minmax(mesh.uvs, {}, &Vec2d::u);
  const auto [min_v, max_v] = std::ranges::minmax(mesh.uvs, {}, &Vec2d::v);
  EXPECT_EQ(min_u.u, 0);
  EXPECT_EQ(max_u.u, 12);
  EXPECT_EQ(min_v.v, 0);
  EXPECT_EQ(max_v.v, 3);
}

TEST(FlatMesh, copies_of_a_vertex_differ_by_whole_tiles) {
  const TriangleMesh mesh = knot_mesh(small_knot());
  std::map<std::tuple<double, double, double>, Vec2d> first;
  int copies = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const auto [known, is_new] = first.insert({key(mesh.positions[i]), mesh.uvs[i]});
    if (is_new) continue;
    ++copies;
    const double du = mesh.uvs[i].u - known->second.u, dv = mesh.uvs[i].v - known->second.v;
    EXPECT_EQ(du, std::round(du));
    EXPECT_EQ(dv, std::round(dv));
  }
  EXPECT_EQ(copies, 48 + 9 + 1);  // the seam along, the seam around, their crossing once again
}

TEST(FlatMesh, every_triangle_spans_half_a_grid_cell_of_the_texture) {
  KnotSpec knot = small_knot();
  knot.unwrap = Unwrap::kParameter;
  const TriangleMesh mesh = knot_mesh(knot);
  const double cell = 12.0 / 48 * 3.0 / 9;
  for (const Triangle& t : mesh.triangles) {
    // Positive: the texture is not mirrored, as triangles are counter-clockwise from outside. The
    // tolerance is that of a file's single precision: this checks size and sign.
    ASSERT_NEAR(uv_area(mesh, t), cell, 1e-7);
  }
}

TEST(FlatMesh, texture_coordinates_are_the_grid_s_in_double_precision) {
  // Geometry stays double until it is written: (i / 48) 12 and (j / 9) 3 to the last bits.
  KnotSpec knot = small_knot();
  knot.unwrap = Unwrap::kParameter;
  const TriangleMesh mesh = knot_mesh(knot);
  for (const Vec2d& uv : mesh.uvs) {
    ASSERT_NEAR(uv.u * 4, std::round(uv.u * 4), 1e-13);
    ASSERT_NEAR(uv.v * 3, std::round(uv.v * 3), 1e-13);
  }
}

TEST(FlatMesh, texture_is_not_mirrored_seen_from_outside) {
  for (const int p : {2, -2}) {
    KnotSpec knot = small_knot();
    knot.p = p;
    const TriangleMesh mesh = knot_mesh(knot);
    for (const Triangle& t : mesh.triangles) {
      const Vec3d a = mesh.positions[t[0]];
      const Vec3d facing = cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
      const Vec3d outward = mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]];
      ASSERT_GT(dot(facing, outward) * uv_area(mesh, t), 0);
    }
  }
}

TEST(FlatMesh, normals_are_unit) {
  const TriangleMesh mesh = knot_mesh(small_knot());
  for (const Vec3d& n : mesh.normals) {
    ASSERT_NEAR(length(n), 1, 1e-13);  // rounding
  }
}

}  // namespace
}  // namespace lumaknot
