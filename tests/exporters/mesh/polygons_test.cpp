#include "exporters/mesh/polygons.h"

#include <gmock/gmock.h>

#include "tests/exporters/mesh/testing.h"

namespace lumaknot {
namespace {

using ::testing::HasSubstr;
using testing::read_bytes;
using testing::refusal;

constexpr std::string_view kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n";

std::string obj(std::string_view faces) { return std::string(kCorners) + std::string(faces); }

TEST(Polygons, an_edge_of_three_faces_is_refused_with_the_faces_and_the_vertices) {
  const std::string error = refusal(obj::read, obj("f 1 2 3\nf 2 1 4\nf 1 2 5\n"));
  EXPECT_THAT(error, HasSubstr("mesh.file knot, line 8: a third face, with those of line 6 and 7"));
  EXPECT_THAT(error, HasSubstr("vertices 1 (0, 0, 0) and 2 (1, 0, 0)"));
}

TEST(Polygons, an_edge_used_twice_in_one_direction_is_refused) {
  const std::string error = refusal(obj::read, obj("f 1 2 3\nf 5 1 2\n"));
  EXPECT_THAT(error, HasSubstr("line 7: a face in the same direction as that of line 6"));
  EXPECT_THAT(error, HasSubstr("vertices 1 (0, 0, 0) and 2 (1, 0, 0)"));
}

TEST(Polygons, the_first_wrong_face_of_the_file_is_reported) {
  const std::string error = refusal(obj::read, obj("f 3 4 5\nf 3 4 1\nf 1 2 3\nf 1 2 4\n"));
  EXPECT_THAT(error, HasSubstr("line 7: "));
}

TEST(Polygons, a_face_twice_is_refused) {
  EXPECT_THAT(refusal(obj::read, obj("f 1 2 3\nf 2 3 1\n")), HasSubstr("line 7: "));
}

TEST(Polygons, both_sides_of_a_sheet_are_a_surface) {
  const TriangleMesh mesh = read_bytes(obj::read, obj("f 1 2 3\nf 3 2 1\n"));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  // Smooth normals cancel, so each side has its own.
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t i : t) {
      EXPECT_NEAR(dot(mesh.normals[i], normalize(testing::area_vector(mesh, t))), 1, 1e-12);
    }
  }
}

TEST(Polygons, corners_that_repeat_are_merged_and_what_is_left_as_a_line_is_dropped) {
  const TriangleMesh mesh = read_bytes(obj::read, obj("f 1 2 2 3 1\nf 1 1 2\nf 1 4 1\n"));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(testing::area(mesh), 0.5);
  EXPECT_THAT(refusal(obj::read, obj("f 1 1 2\n")), HasSubstr("mesh.file knot has no faces, only"));
}

TEST(Polygons, smooth_normals_do_not_depend_on_how_faces_are_cut) {
  // A cube's corner is the same whether its faces are squares or triangles.
  const TriangleMesh cube = read_bytes(
      obj::read,
      "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
      "f 1 4 3 2\nf 5 6 7\nf 5 7 8\nf 1 2 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  ASSERT_EQ(cube.positions.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_LT(length(cube.normals[i] - normalize(cube.positions[i])), 1e-12);  // by symmetry
  }
}

TEST(Polygons, tiny_and_huge_meshes_have_unit_normals) {
  for (const char* size : {"1e-300", "1e-30", "1e30", "3e38"}) {
    const TriangleMesh mesh =
        read_bytes(obj::read, fmt::format("v 0 0 0\nv {0} 0 0\nv 0 {0} 0\nv -{0} -{0} 0\n"
                                          "f 1 2 3\nf 1 3 4 2\n",
                                          size));
    testing::expect_consistent(mesh);
    for (const Vec3d& n : mesh.normals) EXPECT_EQ(std::abs(n.z), 1) << size;
  }
}

TEST(Polygons, a_face_without_area_has_some_unit_normal) {
  testing::expect_consistent(read_bytes(obj::read, "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"));
}

TEST(Polygons, a_concave_face_of_too_many_corners_is_refused) {
  std::string text, face = "f";
  for (int i = 0; i < 5000; ++i) {
    text += fmt::format("v {} {} 0\n", i < 2500 ? i : 5000 - i, (i % 2) + (i < 2500 ? 0 : 5));
    face += fmt::format(" {}", i + 1);
  }
  EXPECT_THAT(refusal(obj::read, text + face), HasSubstr("line 5001: a concave face of 5000"));
}

TEST(Polygons, a_corner_without_a_texture_coordinate_is_refused_with_its_line_where_one_is_needed) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf 2 4 3\n";
  EXPECT_THAT(refusal(obj::read, text, true), HasSubstr("line 7: a corner has no texture"));
  EXPECT_EQ(read_bytes(obj::read, text).triangles.size(), 2u);
}

}  // namespace
}  // namespace lumaknot
