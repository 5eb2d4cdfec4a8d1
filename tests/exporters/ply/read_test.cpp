#include <gmock/gmock.h>

#include "tests/exporters/mesh/testing.h"

namespace lumaknot::ply {
namespace {

using ::testing::HasSubstr;
using testing::raw;
using testing::read_bytes;
using testing::refusal;

std::string replaced(std::string text, std::string_view old, std::string_view now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, text.npos) << old;
  return text.replace(at, old.size(), now);
}

class PlyOfOpenMesh : public ::testing::TestWithParam<OpenMesh::IO::Options::Flag> {};
INSTANTIATE_TEST_SUITE_P(, PlyOfOpenMesh,
                         ::testing::Values(OpenMesh::IO::Options::Default,
                                           OpenMesh::IO::Options::Binary));

TEST_P(PlyOfOpenMesh, a_knot_comes_back) {
  using OpenMesh::IO::Options;
  const ClosedMesh knot = testing::tiny_knot();
  const Options options(Options::value_type(GetParam() | Options::VertexNormal));
  const std::string bytes = testing::written_by_openmesh(knot, ".ply", options);
  testing::expect_same_as_knot(read_bytes(read, bytes), knot, true);
}

TEST(ReadPly, text_and_both_byte_orders_give_the_same_mesh) {
  const TriangleMesh text = read_bytes(read, testing::kTetrahedronPly);
  EXPECT_NEAR(testing::volume(text), 1.0 / 6, 1e-15);  // half base times height / 3
  for (const bool big_endian : {false, true}) {
    const TriangleMesh mesh = read_bytes(read, testing::tetrahedron_ply(big_endian));
    EXPECT_EQ(mesh.positions, text.positions);
    EXPECT_EQ(mesh.triangles, text.triangles);
  }
}

TEST(ReadPly, texture_coordinates_are_known_by_their_usual_names) {
  for (const auto& [u, v] :
       {std::pair{"s", "t"}, std::pair{"u", "v"}, std::pair{"texture_u", "texture_v"}}) {
    const std::string text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty float {}\nproperty float {}\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 0.5 0.25\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n",
        u, v);
    EXPECT_EQ(read_bytes(read, text, true).uvs[0], (Vec2d{0.5, 0.25})) << u;
  }
}

TEST(ReadPly, texture_coordinates_of_faces_are_those_of_their_corners) {
  const TriangleMesh mesh =
      read_bytes(read,
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                 "property list uchar float texcoord\nend_header\n"
                 "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0.5 0.25 1 0 0 1\n",
                 true);
  EXPECT_EQ(mesh.uvs, (Bulk<Vec2d>{{0.5, 0.25}, {1, 0}, {0, 1}}));
}

TEST(ReadPly, normals_are_read) {
  const TriangleMesh mesh =
      read_bytes(read,
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                 "0 0 0 0 3 0\n1 0 0 0 3 4\n0 1 0 0 0 0\n3 0 1 2\n");
  EXPECT_EQ(mesh.normals[0], (Vec3d{0, 1, 0}));
  EXPECT_EQ(mesh.normals[1], (Vec3d{0, 0.6, 0.8}));
  EXPECT_EQ(mesh.normals[2], (Vec3d{0, 0, 1}));  // none given: smooth
}

TEST(ReadPly, other_elements_and_properties_are_skipped) {
  const TriangleMesh mesh = read_bytes(
      read,
      "ply\r\nformat ascii 1.0\r\nobj_info a\r\nelement material 2\r\nproperty list uchar int a\r\n"
      "element nothing 5\r\nelement face 1\r\nproperty uchar red\r\n"
      "property list uchar uint vertex_index\r\nelement vertex 3\r\nproperty float confidence\r\n"
      "property double x\r\nproperty double y\r\nproperty double z\r\nend_header\r\n"
      "0\r\n2 7 7\r\n255 3 0 1 2\r\nnan 0 0 0\r\n0 1 0 0\r\n0 0 1 0\r\n");
  EXPECT_EQ(testing::area(mesh), 0.5);
}

struct Refused {
  std::string text, place, what;
};

TEST(ReadPly, errors_in_text_give_their_line) {
  const std::string text = testing::kTetrahedronPly;
  const Refused cases[] = {
      {"obj\n", "line 1", "not a PLY file"},
      {"ply\nformat ascii 1.0\nelement vertex 3\n", "line 1", "no line end_header"},
      {replaced(text, "ascii", "asci"), "line 2", "format asci is not known"},
      {replaced(text, "format ascii 1.0\n", ""), "line 9", "no format"},
      {replaced(text, "float y", "flaot y"), "line 6", "type flaot is not known"},
      {replaced(text, "comment", "commment"), "line 3", "commment is not a keyword"},
      {replaced(text, "element vertex 4\n", ""), "line 4", "before any element"},
      {replaced(text, "vertex 4", "vertex -4"), "line 4", "-4 is not a count"},
      {replaced(text, "vertex 4", "vertex 1000000000000000000"), "line", "can't hold"},
      {replaced(text, "face 4", "face 18446744073709551615"), "line", "can't hold"},
      {replaced(text, "face 4", "face 5"), "line 19", "cut short"},
      {replaced(text, "face 4", "face 3"), "line 18", "more lines than the header counts"},
      {replaced(text, "property float z\n", ""), "line", "no x, y and z"},
      {replaced(text, "vertex_indices", "corners"), "line", "no list vertex_indices"},
      {replaced(text, "0 1 0\n", "0 one 0\n"), "line 13", "one is not a number"},
      {replaced(text, "0 1 0\n", "0 nan 0\n"), "line 13", "nan is not a finite"},
      {replaced(text, "0 1 0\n", "0 1e40 0\n"), "line 13", "not a finite float32"},
      {replaced(text, "0 1 0\n", "0 1\n"), "line 13", "a number is missing"},
      {replaced(text, "0 1 0\n", "0 1 0 0\n"), "line 13", "0 after the element's last number"},
      {replaced(text, "3 0 1 3\n", "3 0 1 4\n"), "line 16", "vertex 4 does not exist"},
      {replaced(text, "3 0 1 3\n", "3 0 1 -3\n"), "line 16", "-3 is not a vertex index"},
      {replaced(text, "3 0 1 3\n", "3 0 1 0.5\n"), "line 16", "0.5 is not a vertex index"},
      {replaced(text, "3 0 1 3\n", "2 0 1\n"), "line 16", "a face of 2 corners"},
      {replaced(text, "3 0 1 3\n", "1e18 0 1 3\n"), "line 16", "can't hold"},
      {replaced(text, "3 0 1 3\n", "nan 0 1 3\n"), "line 16", "a list of nan"},
  };
  for (const Refused& c : cases) {
    const std::string error = refusal(read, c.text);
    EXPECT_THAT(error, HasSubstr("mesh.file knot, " + c.place)) << c.text;
    EXPECT_THAT(error, HasSubstr(c.what)) << c.text;
  }
}

TEST(ReadPly, errors_in_binary_give_their_byte) {
  const std::string bytes = testing::tetrahedron_ply(false);
  const std::size_t data = bytes.find("end_header\n") + 11;
  // A vertex has 8 + 4 + 2 + 1 bytes; a face 4 + 2, then 1 + 3 * 4.
  const std::size_t faces = data + 4 * 15;
  std::string far = bytes;
  far.replace(faces + 19 + 7, 4, raw(std::int32_t(90000000)));
  EXPECT_THAT(refusal(read, far), HasSubstr(fmt::format("byte {}: vertex 90000000", faces + 19)));
  std::string nan = bytes;
  nan.replace(data + 15, 8, raw(std::nan("")));
  EXPECT_THAT(refusal(read, nan), HasSubstr(fmt::format("byte {}: nan", data + 15 + 8)));
  EXPECT_THAT(refusal(read, bytes.substr(0, bytes.size() - 1)),
              HasSubstr(fmt::format("byte {}: ", bytes.size() - 12)));
  EXPECT_THAT(refusal(read, bytes + "more"),
              HasSubstr(fmt::format("byte {}: more bytes", bytes.size())));
  EXPECT_THAT(refusal(read, replaced(bytes, "vertex 4", "vertex 4000000000")),
              HasSubstr("counts 4000000000 of vertex"));
}

}  // namespace
}  // namespace lumaknot::ply
