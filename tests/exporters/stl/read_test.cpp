#include <gmock/gmock.h>

#include "tests/exporters/mesh/testing.h"

namespace lumaknot::stl {
namespace {

using ::testing::HasSubstr;
using testing::raw;
using testing::read_bytes;
using testing::refusal;

class StlOfOpenMesh : public ::testing::TestWithParam<OpenMesh::IO::Options::Flag> {};
INSTANTIATE_TEST_SUITE_P(, StlOfOpenMesh,
                         ::testing::Values(OpenMesh::IO::Options::Default,
                                           OpenMesh::IO::Options::Binary));

TEST_P(StlOfOpenMesh, a_knot_comes_back_with_its_facets_normals) {
  const ClosedMesh knot = testing::tiny_knot();
  const OpenMesh::IO::Options options{OpenMesh::IO::Options::value_type(GetParam())};
  const std::string extension = GetParam() == OpenMesh::IO::Options::Binary ? ".stlb" : ".stla";
  const std::string bytes = testing::written_by_openmesh(knot, extension, options);
  const TriangleMesh mesh = read_bytes(read, bytes);
  // OpenMesh's text has six digits, of numbers up to 2.
  ASSERT_EQ(mesh.triangles.size(), knot.n_faces());
  EXPECT_EQ(read(bytes, "knot").positions.size(), knot.n_vertices());
  for (const auto face : knot.faces()) {
    const Triangle& t = mesh.triangles[std::size_t(face.idx())];
    const Vec3d normal = normalize(testing::area_vector(mesh, t));
    std::size_t corner = 0;
    for (const auto v : knot.fv_range(face)) {
      const auto& p = knot.point(v);
      EXPECT_LT(length(mesh.positions[t[corner]] - Vec3d{p[0], p[1], p[2]}), 1e-5);
      EXPECT_LT(length(mesh.normals[t[corner]] - normal), 1e-4);  // six digits over edges of 0.3
      ++corner;
    }
  }
}

TEST(ReadStl, corners_at_equal_positions_are_one) {
  for (const std::string& bytes : {testing::tetrahedron_stl(), testing::tetrahedron_stl_text()}) {
    EXPECT_EQ(read(bytes, "knot").positions.size(), 4u);
    // Facets without normals are smooth, so a corner is one vertex.
    EXPECT_EQ(read_bytes(read, bytes).positions.size(), 4u);
  }
}

TEST(ReadStl, minus_zero_is_where_zero_is) {
  std::string text = testing::tetrahedron_stl_text();
  text.replace(text.find("vertex 0 0 0"), 12, "vertex -0 0 -0");
  EXPECT_EQ(read(text, "knot").positions.size(), 4u);
}

TEST(ReadStl, binary_that_begins_with_solid_is_binary) {
  std::string bytes = testing::tetrahedron_stl();
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(read_bytes(read, bytes).triangles.size(), 4u);
}

TEST(ReadStl, several_solids_in_capitals_become_one_mesh) {
  const std::string solid =
      "SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 {0}\nVERTEX 1 0 {0}\nVERTEX 0 1 {0}\n"
      "ENDLOOP\nENDFACET\nENDSOLID\n";
  const std::string text =
      fmt::format(fmt::runtime(solid), 0) + fmt::format(fmt::runtime(solid), 1);
  EXPECT_EQ(testing::area(read_bytes(read, text)), 1);
}

struct Refused {
  std::string bytes, place, what;
};

TEST(ReadStl, errors_give_their_place) {
  const std::string binary = testing::tetrahedron_stl(), text = testing::tetrahedron_stl_text();
  std::string nan = binary;
  nan.replace(84 + 50 + 12, 4, raw(std::nanf("")));
  std::string lie = binary;
  lie.replace(80, 4, raw(std::uint32_t(4000000000)));
  const auto with = [&](std::string_view old, std::string_view now) {
    return std::string(text).replace(text.find(old), old.size(), now);
  };
  const Refused cases[] = {
      {"not a mesh", "byte 10", "neither the word solid"},
      {binary.substr(0, binary.size() - 1), "byte 80", "neither"},
      {lie, "byte 80", "neither"},
      {nan, "byte 146", "not finite"},
      {text.substr(0, text.size() - 22), "line 30", "cut short before endsolid"},
      {text.substr(0, text.find("endloop")), "line 7", "cut short before endloop"},
      {with("facet", "faucet"), "line 2", "faucet where facet or endsolid"},
      {with("normal 0", "normal x"), "line 2", "x is not a number"},
      {with("outer", "inner"), "line 3", "inner where outer"},
      {with("vertex 0 0 0", "vertex 0 0"), "line 4", "a number is missing"},
      {with("vertex 0 0 0", "vertex 0 0 nan"), "line 4", "nan is not a finite"},
      {with("endloop", "vertex 1 1 1\nendloop"), "line 7", "vertex where endloop"},
      {text + "facet normal 0 0 0\n", "line 31", "facet where solid"},
  };
  for (const Refused& c : cases) {
    const std::string error = refusal(read, c.bytes);
    EXPECT_THAT(error, HasSubstr("mesh.file knot, " + c.place + ": ")) << c.bytes;
    EXPECT_THAT(error, HasSubstr(c.what)) << c.bytes;
  }
}

}  // namespace
}  // namespace lumaknot::stl
