#include <gmock/gmock.h>

#include <bit>
#include <random>

#include "tests/exporters/mesh/testing.h"

namespace lumaknot::obj {
namespace {

using ::testing::HasSubstr;
using testing::read_bytes;
using testing::refusal;

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(ReadObj, a_knot_written_by_openmesh_comes_back) {
  using OpenMesh::IO::Options;
  const ClosedMesh knot = testing::tiny_knot();
  const TriangleMesh mesh =
      read_bytes(read, testing::written_by_openmesh(knot, ".obj", Options::VertexNormal));
  testing::expect_same_as_knot(mesh, knot, true);
}

TEST(ReadObj, indices_may_count_back_from_the_last) {
  const TriangleMesh mesh =
      read_bytes(read, "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\n");
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.positions, (Bulk<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(ReadObj, lines_may_end_as_on_windows_continue_and_have_comments) {
  const TriangleMesh mesh = read_bytes(
      read, "# made by hand\r\nv 0 0 0 # first\r\n\r\nv 1 0 \\\r\n 0\r\nv 0 1 0\r\nf 1 2\\\n 3");
  EXPECT_EQ(testing::area(mesh), 0.5);
}

TEST(ReadObj, groups_materials_points_lines_weights_and_colours_are_skipped) {
  const TriangleMesh mesh =
      read_bytes(read,
                 "mtllib a.mtl\no a\ng b c\ns off\nusemtl d\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\n"
                 "v 0 1 0\np 1\nl 1 2 3\nvp 0.3\nf 1 2 3\n");
  EXPECT_EQ(testing::area(mesh), 0.5);
}

TEST(ReadObj, vertices_may_follow_the_faces) {
  EXPECT_EQ(testing::area(read_bytes(read, "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n")), 0.5);
}

TEST(ReadObj, float32_in_its_shortest_digits_comes_back_as_the_same_float32) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const float value = std::bit_cast<float>(std::uint32_t(random()));
    if (!std::isfinite(value)) continue;
    const std::string text = fmt::format("v {} 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\n", value);
    const Polygons polygons = read(text, "mesh.file knot");
    EXPECT_EQ(float(polygons.positions[0].x), value) << text;
  }
}

TEST(ReadObj, a_number_below_what_double_holds_is_zero) {
  EXPECT_EQ(read("v 1e-400 0 0\nv +1 0 0\nv 0 1 0\nf 1 2 3\n", "knot").positions[0], Vec3d{});
}

struct Refused {
  std::string text, place, what;
};

TEST(ReadObj, errors_give_their_line) {
  const std::string triangle(kTriangle);
  const Refused cases[] = {
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "line 4", "vertex 9 does not exist, the file has 3"},
      {triangle + "f 1 2 99999999999999999999\n", "line 5", "does not exist"},
      {triangle + "f 0 1 2\n", "line 5", "vertex 0 does not exist"},
      {triangle + "f -4 1 2\n", "line 5", "vertex -4 does not exist, 3 come before"},
      {triangle + "f 1/5 2/5 3/5\n", "line 5", "texture coordinate 5 does not exist"},
      {triangle + "f 1//1 2//1 3//1\n", "line 5", "normal 1 does not exist"},
      {triangle + "f 1/1/1/1 2 3\n", "line 5", "not a face corner"},
      {triangle + "f 1 2 x\n", "line 5", "x is not a valid vertex index"},
      {triangle + "f 1 2 1.5\n", "line 5", "1.5 is not a valid vertex index"},
      {triangle + "f 1 2\n", "line 5", "a face of 2 corners"},
      {"v 0 0\n", "line 1", "a number is missing"},
      {"v 0 0 zero\n", "line 1", "zero is not a number"},
      {"v 0 0 0,5\n", "line 1", "0,5 is not a number"},
      {"\n\nv 0 \\\n 0 nan\n", "line 4", "nan is not a finite"},
      {"v 0 0 inf\n", "line 1", "inf is not a finite"},
      {"v 0 0 1e400\n", "line 1", "1e400 is not a finite"},
      {"v 0 0 1e39\n", "line 1", "1e39 is not a finite float32 number"},
      {"vt nan\n", "line 1", "nan"},
      {"vt 0 inf\n", "line 1", "inf"},
      {"\x89PNG\r\n\x1a\n" + std::string(20, '\0'), "line 3", "not text"},
  };
  for (const Refused& c : cases) {
    const std::string error = refusal(read, c.text);
    EXPECT_THAT(error, HasSubstr("mesh.file knot, " + c.place + ": ")) << c.text;
    EXPECT_THAT(error, HasSubstr(c.what)) << c.text;
    EXPECT_THAT(error, ::testing::Not(HasSubstr("\n")));
  }
}

TEST(ReadObj, a_long_word_is_quoted_short_and_printable) {
  const std::string error = refusal(read, "v 0 0 " + std::string(1000, '\x01') + "\n");
  EXPECT_LT(error.size(), 200u);
  EXPECT_THAT(error, HasSubstr("??????..."));
}

}  // namespace
}  // namespace lumaknot::obj
