#include "meshgen/measure.h"

#include <gtest/gtest.h>

namespace lumaknot {
namespace {

/// The tetrahedron of the origin and the three unit points, facing outward.
ClosedMesh corner_tetrahedron() {
  ClosedMesh mesh;
  const auto o = mesh.add_vertex({0, 0, 0}), x = mesh.add_vertex({1, 0, 0});
  const auto y = mesh.add_vertex({0, 1, 0}), z = mesh.add_vertex({0, 0, 1});
  mesh.add_face(o, y, x);
  mesh.add_face(o, x, z);
  mesh.add_face(o, z, y);
  mesh.add_face(x, y, z);
  return mesh;
}

TEST(Measure, a_tetrahedron_is_a_sphere) {
  const ClosedMesh mesh = corner_tetrahedron();
  const std::vector<ConnectedComponent> all = connected_components(mesh);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].euler_characteristic(), 2);
  EXPECT_EQ(all[0].genus(), 0);
  EXPECT_EQ(all[0].boundary_edges, 0);
}

TEST(Measure, a_tetrahedron_s_volume_is_a_sixth_wherever_it_lies) {
  ClosedMesh mesh = corner_tetrahedron();
  EXPECT_DOUBLE_EQ(volume(mesh), 1.0 / 6);
  for (const auto vertex : mesh.vertices()) mesh.point(vertex) += ClosedMesh::Point(8, -4, 2);
  EXPECT_NEAR(volume(mesh), 1.0 / 6, 1e-13);  // the sum cancels terms a hundred times as large
}

TEST(Measure, volume_is_negative_turned_inside_out) {
  ClosedMesh mesh = corner_tetrahedron();
  for (const auto vertex : mesh.vertices()) mesh.point(vertex)[0] *= -1;
  EXPECT_DOUBLE_EQ(volume(mesh), -1.0 / 6);
}

TEST(Measure, a_hole_shows_as_boundary) {
  ClosedMesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0});
  const auto c = mesh.add_vertex({0, 1, 0}), d = mesh.add_vertex({1, 1, 0});
  mesh.add_face(a, b, c);
  mesh.add_face(b, d, c);
  const std::vector<ConnectedComponent> all = connected_components(mesh);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].boundary_edges, 4);
  EXPECT_EQ(all[0].euler_characteristic(), 1);  // a disc
}

TEST(Measure, components_are_counted_separately) {
  ClosedMesh mesh = corner_tetrahedron();
  const auto a = mesh.add_vertex({5, 0, 0}), b = mesh.add_vertex({6, 0, 0});
  mesh.add_face(a, b, mesh.add_vertex({5, 1, 0}));
  const std::vector<ConnectedComponent> all = connected_components(mesh);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].faces, 4);
  EXPECT_EQ(all[0].edges, 6);
  EXPECT_EQ(all[1].vertices, 3);
  EXPECT_EQ(all[1].boundary_edges, 3);
}

TEST(Measure, area_of_a_tetrahedron_is_its_four_faces) {
  EXPECT_NEAR(area(corner_tetrahedron()), 1.5 + std::sqrt(3.0) / 2, 1e-15);  // rounding
}

}  // namespace
}  // namespace lumaknot
