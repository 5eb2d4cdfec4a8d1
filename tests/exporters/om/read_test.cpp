#include <gmock/gmock.h>

#include "tests/exporters/mesh/testing.h"

namespace lumaknot::om {
namespace {

using OpenMesh::IO::Options;
using ::testing::HasSubstr;
using testing::raw;
using testing::read_bytes;
using testing::refusal;

TEST(ReadOm, a_knot_comes_back_with_its_normals) {
  const std::string bytes = testing::written_by_openmesh(
      testing::tiny_knot(), ".om", Options(Options::Binary | Options::VertexNormal));
  testing::expect_same_as_knot(read_bytes(read, bytes), testing::tiny_knot(), true);
}

TEST(ReadOm, texture_coordinates_of_corners_come_back) {
  const ClosedMesh knot = testing::tiny_knot();
  const TriangleMesh mesh = read_bytes(read, testing::knot_om(), true);
  const TriangleMesh flat = knot_mesh(testing::tiny_spec());
  ASSERT_EQ(mesh.triangles.size(), flat.triangles.size());
  EXPECT_EQ(mesh.positions.size(), flat.positions.size());  // the seam is there
  for (const auto face : knot.faces()) {
    std::size_t corner = 0;
    for (const auto h : knot.fh_range(face)) {
      const auto uv = knot.texcoord2D(h);
      const Vec2d read = mesh.uvs[mesh.triangles[std::size_t(face.idx())][corner++]];
      EXPECT_EQ(float(read.u), float(uv[0]));  // kept in float32
      EXPECT_EQ(float(read.v), float(uv[1]));
    }
  }
}

TEST(ReadOm, texture_coordinates_of_vertices_come_back) {
  ClosedMesh knot = testing::tiny_knot();
  knot.request_vertex_texcoords2D();
  for (const auto v : knot.vertices()) knot.set_texcoord2D(v, {v.idx() / 64.0, 1});
  const Polygons polygons = read(
      testing::written_by_openmesh(knot, ".om", Options(Options::Binary | Options::VertexTexCoord)),
      "knot");
  ASSERT_EQ(polygons.uvs.size(), knot.n_vertices());
  for (std::size_t i = 0; i < polygons.uvs.size(); ++i) {
    EXPECT_EQ(polygons.uvs[i], (Vec2d{double(i) / 64, 1}));
  }
}

TEST(ReadOm, status_and_custom_properties_are_skipped) {
  ClosedMesh knot = testing::tiny_knot();
  OpenMesh::VPropHandleT<int> property;
  knot.add_property(property, "a number");
  knot.property(property).set_persistent(true);
  const std::string plain =
      testing::written_by_openmesh(testing::tiny_knot(), ".om", Options::Binary);
  const std::string bytes = testing::written_by_openmesh(
      knot, ".om", Options(Options::Binary | Options::Status | Options::Custom));
  ASSERT_GT(bytes.size(), plain.size() + 4 * 2 * knot.n_vertices());  // both are present
  EXPECT_EQ(read_bytes(read, bytes).positions, read_bytes(read, plain).positions);
}

/// The knot's bytes with `now` replacing those at `at`.
std::string with(std::size_t at, std::string_view now) {
  return testing::knot_om().replace(at, now.size(), now);
}

TEST(ReadOm, errors_give_their_place) {
  const ClosedMesh knot = testing::tiny_knot();
  const std::string bytes = testing::knot_om();
  const std::size_t positions = 16 + 2, normals = positions + 24 * knot.n_vertices() + 2;
  const std::size_t halfedges = normals + 24 * knot.n_vertices() + 2;
  const std::pair<std::string, std::string> cases[] = {
      {"OM", "byte 0: not an OM file"},
      {with(0, "\x89PNG"), "byte 0: not an OM file"},
      {with(3, "\x20"), "byte 3: version 1.0"},
      {with(3, "\xff"), "byte 3: version 7.31"},
      {with(4, raw(std::uint32_t(4000000000))), "byte 18: 96000000000 bytes expected"},
      {with(8, raw(std::uint32_t(4000000000))), "bytes expected"},
      {with(12, raw(std::uint32_t(4000000000))), "bytes expected"},
      {bytes.substr(0, 16), "byte 16: the positions are missing"},
      {bytes.substr(0, halfedges - 2), "the halfedges are missing"},
      {bytes.substr(0, halfedges + 5), "bytes expected"},
      {with(positions + 24, raw(std::nan(""))), "vertex 1: nan is not a finite"},
      // Each halfedge is its next one, its vertex and its face: 3 bytes with 45 edges.
      {with(halfedges, "\x7f"), fmt::format("byte {}: halfedge 127", halfedges)},
      {with(halfedges + 1, "\x7f"), fmt::format("byte {}: vertex 127", halfedges + 1)},
      {with(halfedges + 2, "\x7f"), fmt::format("byte {}: face 127", halfedges + 2)},
  };
  ASSERT_EQ(knot.n_edges(), 45u);
  for (const auto& [text, what] : cases) {
    const std::string error = refusal(read, text);
    EXPECT_THAT(error, HasSubstr("mesh.file knot, ")) << what;
    EXPECT_THAT(error, HasSubstr(what));
  }
}

}  // namespace
}  // namespace lumaknot::om
