#include <gmock/gmock.h>

#include "tests/exporters/mesh/testing.h"

namespace lumaknot::povray {
namespace {

using ::testing::HasSubstr;
using testing::read_bytes;
using testing::refusal;

TEST(ReadPov, the_exported_knot_comes_back_in_float32) {
  const TriangleMesh knot = knot_mesh(testing::tiny_spec());
  const TriangleMesh mesh = read_bytes(read_pov, testing::knot_pov(), true);
  ASSERT_EQ(mesh.triangles.size(), knot.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t read = mesh.triangles[t][corner], made = knot.triangles[t][corner];
      const Vec3d p = knot.positions[made], q = mesh.positions[read];
      EXPECT_EQ(float(q.x), float(p.x));
      EXPECT_EQ(float(q.y), float(p.y));
      EXPECT_EQ(float(q.z), float(p.z));
      EXPECT_EQ(float(mesh.uvs[read].u), float(knot.uvs[made].u));
      EXPECT_EQ(float(mesh.uvs[read].v), float(knot.uvs[made].v));
      // Written with nine digits, renormalised.
      EXPECT_LT(length(mesh.normals[read] - knot.normals[made]), 3e-7);
    }
  }
}

TEST(ReadPov, a_whole_exported_scene_holds_its_mesh) {
  const Scene scene = testing::small_scene();
  const Package package = pov_package(scene, "knot");
  const auto* file = testing::find(package, "knot.pov");
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(read_bytes(read_pov, file->bytes, true).triangles.size(), scene.mesh.triangles.size());
}

TEST(ReadPov, indices_of_normals_and_texture_coordinates_are_separate) {
  const TriangleMesh mesh =
      read_bytes(read_pov,
                 "mesh2 { vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> }\n"
                 "normal_vectors { 1, <0,2,0> } uv_vectors { 2, <0.5,0.25>, <-1e0,+.5> }\n"
                 "face_indices { 1, <0,1,2>, 0, 1, 2 } normal_indices { 1, <0,0,0> }\n"
                 "uv_indices { 1, <0,1,1> } }",
                 true);
  EXPECT_EQ(mesh.uvs, (Bulk<Vec2d>{{0.5, 0.25}, {-1, 0.5}, {-1, 0.5}}));
  for (const Vec3d& n : mesh.normals) EXPECT_EQ(n, (Vec3d{0, 1, 0}));
}

TEST(ReadPov, comments_strings_textures_and_other_objects_are_skipped) {
  const std::string text = std::string("#version 3.7; /* mesh2 { /* nested */ } */\n") +
                           "#declare Name = \"mesh2 { \\\" }\";\nsphere { <0,0,0>, 1 }\n" +
                           "// mesh2 {\n" + testing::kTetrahedronPov +
                           "#declare Other = mesh2 { texture_list { 1, texture { T } }\n"
                           "vertex_vectors { 3 <5,0,0> <6,0,0> <5,1,0> }\n"
                           "face_indices { 1 <0,1,2>, 0 } inside_vector <0,0,1> hollow }\n";
  const TriangleMesh mesh = read_bytes(read_pov, text);
  EXPECT_EQ(mesh.triangles.size(), 5u);
  // The tetrahedron's, and one triangle of each of two other mesh2.
  EXPECT_NEAR(testing::area(mesh), 1.5 + std::sqrt(3.0) / 2 + 0.5, 1e-12);
}

struct Refused {
  std::string text, place, what;
};

TEST(ReadPov, errors_give_their_line) {
  const std::string text = testing::kTetrahedronPov;
  const auto with = [&](std::string_view old, std::string_view now) {
    return std::string(text).replace(text.find(old), old.size(), now);
  };
  const Refused cases[] = {
      {"sphere { <0,0,0>, 1 }\n", "line 2", "without a mesh2"},
      {with("<1,0,0>", "<1*2,0,0>"), "line 3", "* where , was expected: only numbers"},
      {with("<1,0,0>", "<R,0,0>"), "line 3", "R is not a number: only numbers"},
      {with("<1,0,0>", "<nan,0,0>"), "line 3", "nan is not a number"},
      {with("<1,0,0>", "<1e39,0,0>"), "line 3", "1e39 is not a finite float32"},
      {with("<1,0,0>", "<1,0>"), "line 3", "> where , was expected"},
      {with("<1,0,0>", "x"), "line 3", "x where < was expected"},
      {with("{ 4,", "{ 4000000000,"), "line 3", "a list of 4000000000"},
      {with("{ 4,", "{ N,"), "line 3", "N is not a number"},
      {with("{ 4,", "{ 3,"), "line 3", "< where } was expected"},
      {with("{ 4,", "{ -4,"), "line 3", "-4 is not a count"},
      {with("<0,1,3>", "<0,1,4>"), "line 4", "vertex 4 does not exist, the mesh2 has 4"},
      {with("<0,3,2>", "<0,3,0.5>"), "line 5", "0.5 is not a count or an index"},
      {with("pigment", "rotate 90*x pigment"), "line 6", "rotate moves the mesh"},
      {with("pigment", "uv_indices { 1, <0,0,0> } pigment"), "line 7", "1 uv_indices for 4 faces"},
      {with("rgb 1 }\n}", ""), "line 7", "the { of line 6 is not closed"},
      {with("rgb 1 }\n}", "rgb 1 }\n"), "line 8", "the mesh2 of line 2 does not end"},
      {"/* mesh2", "line 1", "the comment of line 1 does not end"},
      {"\"mesh2", "line 1", "a string that does not end"},
  };
  for (const Refused& c : cases) {
    const std::string error = refusal(read_pov, c.text);
    EXPECT_THAT(error, HasSubstr("mesh.file knot, " + c.place + ": ")) << c.text;
    EXPECT_THAT(error, HasSubstr(c.what)) << c.text;
  }
}

}  // namespace
}  // namespace lumaknot::povray
