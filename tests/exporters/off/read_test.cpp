#include <gmock/gmock.h>

#include "tests/exporters/mesh/testing.h"

namespace lumaknot::off {
namespace {

using ::testing::HasSubstr;
using testing::read_bytes;
using testing::refusal;

TEST(ReadOff, a_knot_written_by_openmesh_comes_back) {
  using OpenMesh::IO::Options;
  const ClosedMesh knot = testing::tiny_knot();
  const std::string text = testing::written_by_openmesh(knot, ".off", Options::VertexNormal);
  ASSERT_TRUE(text.starts_with("NOFF"));
  testing::expect_same_as_knot(read_bytes(read, text), knot, true);
}

TEST(ReadOff, counts_may_follow_the_header_directly_and_edges_be_missing) {
  const std::string text = testing::kTetrahedronOff;
  const TriangleMesh mesh = read_bytes(read, text);
  EXPECT_NEAR(testing::volume(mesh), 1.0 / 6, 1e-15);
  EXPECT_EQ(read_bytes(read, "OFF 4 4" + text.substr(9)).positions, mesh.positions);
  EXPECT_EQ(read_bytes(read, "# by hand\nOFF # here\n\n#\n4 4" + text.substr(9)).positions,
            mesh.positions);
}

TEST(ReadOff, normals_texture_coordinates_and_colours_are_in_openmeshs_order) {
  const TriangleMesh mesh = read_bytes(read,
                                       "STCNOFF\n3 1 0\n0 0 0 0 2 0 255 0 0 0.5 0.25\n"
                                       "1 0 0 0 1 0 0.1 0.2 0.3 1 1 0\n0 1 0 0 1 0 0 1\n"
                                       "3 0 1 2 255 0 0\n",
                                       true);
  EXPECT_EQ(mesh.uvs, (Bulk<Vec2d>{{0.5, 0.25}, {1, 0}, {0, 1}}));
  for (const Vec3d& n : mesh.normals) EXPECT_EQ(n, (Vec3d{0, 1, 0}));
}

TEST(ReadOff, texture_coordinates_written_by_openmesh_come_back) {
  using OpenMesh::IO::Options;
  ClosedMesh knot = testing::tiny_knot();
  knot.request_vertex_texcoords2D();
  for (const auto v : knot.vertices()) knot.set_texcoord2D(v, {v.idx() / 64.0, -v.idx() / 32.0});
  const std::string text = testing::written_by_openmesh(
      knot, ".off", Options(Options::VertexNormal | Options::VertexTexCoord));
  const Polygons polygons = read(text, "knot");
  ASSERT_EQ(polygons.uvs.size(), knot.n_vertices());
  for (std::size_t i = 0; i < polygons.uvs.size(); ++i) {
    EXPECT_EQ(polygons.uvs[i], (Vec2d{double(i) / 64, -double(i) / 32}));
  }
}

struct Refused {
  std::string text, place, what;
};

TEST(ReadOff, errors_give_their_line) {
  const std::string text = testing::kTetrahedronOff;
  const auto with = [&](std::string_view old, std::string_view now) {
    return std::string(text).replace(text.find(old), old.size(), now);
  };
  const Refused cases[] = {
      {"\n\n", "line 3", "empty"},
      {with("OFF", "off"), "line 1", "off where OFF was expected"},
      {with("OFF", "4OFF"), "line 1", "4OFF has coordinates that are not 3"},
      {with("OFF", "OFF BINARY"), "line 1", "binary OFF is not read"},
      {"OFF\n", "line 2", "cut short before the counts"},
      {with("4 4 6", "4"), "line 2", "a count is missing"},
      {with("4 4 6", "4000000000000 4"), "line 2", "more than the file can hold"},
      {with("4 4 6", "4 18446744073709551615"), "line 2", "more than the file can hold"},
      {with("4 4 6", "4 5 6"), "line 11", "cut short after 4 of 5 faces"},
      {with("4 4 6", "4 3 6"), "line 10", "more lines than the header counts"},
      {with("0 1 0\n", "0 1\n"), "line 5", "a number is missing"},
      {with("0 1 0\n", "0 nan 0\n"), "line 5", "nan is not a finite"},
      {with("3 0 1 3", "3 0 1 4"), "line 8", "vertex 4 does not exist, the file has 4"},
      {with("3 0 1 3", "3 0 1 -1"), "line 8", "-1 is not a count"},
      {with("3 0 1 3", "4 0 1 3"), "line 8", "a count is missing"},
      {with("3 0 1 3", "2 0 1"), "line 8", "a face of 2 corners"},
      {"STOFF\n3 1 0\n0 0 0 1\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n", "line 3", "no texture coordinate"},
      {"STOFF\n3 1 0\n0 0 0 1 inf\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n", "line 3",
       "no texture coordinate"},
  };
  for (const Refused& c : cases) {
    const std::string error = refusal(read, c.text);
    EXPECT_THAT(error, HasSubstr("mesh.file knot, " + c.place + ": ")) << c.text;
    EXPECT_THAT(error, HasSubstr(c.what)) << c.text;
  }
}

}  // namespace
}  // namespace lumaknot::off
