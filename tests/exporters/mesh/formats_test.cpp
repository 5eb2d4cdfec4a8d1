// The bytes of a tetrahedron in each format, according to the formats' descriptions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstring>
#include <sstream>

#include "exporters/obj/format.h"
#include "exporters/off/format.h"
#include "exporters/om/format.h"
#include "exporters/ply/format.h"
#include "exporters/povray/format.h"
#include "exporters/povray/scene.h"
#include "exporters/stl/format.h"
#include "tests/exporters/testing.h"

namespace lumaknot {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing::tetrahedron;

template <class Write>
std::string written(Write write, const TriangleMesh& mesh, const MeshFileOptions& options = {}) {
  std::ostringstream stream;
  write(stream, mesh, options);
  return std::move(stream).str();
}

template <class T>
T number_at(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

/// Little-endian, byte by byte, as the formats require, on any machine.
void append_float(std::string& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8) bytes += char(bits >> shift & 255);
}

TEST(ObjFile, tetrahedron_has_its_lines) {
  EXPECT_EQ(written(obj::write, tetrahedron()),
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0.1\n"
            "vt 0 0\nvt 1 0\nvt 0 1\nvt 0.25 1e-07\n"
            "vn -1 0 0\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\n"
            "f 1/1/1 3/3/3 2/2/2\nf 1/1/1 2/2/2 4/4/4\nf 1/1/1 4/4/4 3/3/3\nf 2/2/2 3/3/3 4/4/4\n");
}

TEST(ObjFile, vertices_of_a_seam_share_their_position_and_nothing_else) {
  TriangleMesh mesh = tetrahedron();
  mesh.positions[1] = mesh.positions[0];
  const std::string text = written(obj::write, mesh);
  EXPECT_THAT(text, StartsWith("v 0 0 0\nv 0 1 0\nv 0 0 0.1\nvt 0 0\nvt 1 0\n"));
  EXPECT_THAT(text, HasSubstr("\nf 1/1/1 2/3/3 1/2/2\nf 1/1/1 1/2/2 3/4/4\n"));
}

TEST(OffFile, tetrahedron_has_its_lines) {
  EXPECT_EQ(written(off::write, tetrahedron()),
            "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

const std::string kPlyProperties =
    "comment made by lumaknot\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
    "property float s\nproperty float t\nelement face 4\n"
    "property list uchar uint vertex_indices\nend_header\n";

TEST(PlyFile, tetrahedron_as_text_has_its_lines) {
  EXPECT_EQ(written(ply::write, tetrahedron(), {.ascii = true}),
            "ply\nformat ascii 1.0\n" + kPlyProperties +
                "0 0 0 -1 0 0 0 0\n1 0 0 1 0 0 1 0\n0 1 0 0 1 0 0 1\n0 0 0.1 0 0 1 0.25 1e-07\n"
                "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
}

TEST(PlyFile, tetrahedron_has_its_bytes) {
  const TriangleMesh mesh = tetrahedron();
  std::string expected = "ply\nformat binary_little_endian 1.0\n" + kPlyProperties;
  for (std::size_t i = 0; i < 4; ++i) {
    for (const double c : components(mesh.positions[i])) append_float(expected, float(c));
    for (const double c : components(mesh.normals[i])) append_float(expected, float(c));
    append_float(expected, float(mesh.uvs[i].u));
    append_float(expected, float(mesh.uvs[i].v));
  }
  for (const Triangle& t : mesh.triangles) {
    expected += '\3';
    for (const std::uint32_t index : t) expected += {char(index), 0, 0, 0};
  }
  EXPECT_EQ(written(ply::write, mesh), expected);
}

TEST(StlFile, tetrahedron_has_its_bytes) {
  const TriangleMesh mesh = tetrahedron();
  const std::string bytes = written(stl::write, mesh);
  ASSERT_EQ(bytes.size(), 84u + 4 * 50);
  EXPECT_EQ(bytes.substr(0, 84), "lumaknot" + std::string(72, '\0') + std::string("\4\0\0\0", 4));
  for (std::size_t t = 0; t < 4; ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3d& p = mesh.positions[mesh.triangles[t][c]];
      const std::size_t at = 84 + 50 * t + 12 + 12 * c;
      EXPECT_EQ(number_at<float>(bytes, at), float(p.x));
      EXPECT_EQ(number_at<float>(bytes, at + 4), float(p.y));
      EXPECT_EQ(number_at<float>(bytes, at + 8), float(p.z));
    }
    EXPECT_EQ(number_at<std::uint16_t>(bytes, 84 + 50 * t + 48), 0);
  }
  EXPECT_EQ(number_at<float>(bytes, 84 + 8), -1);  // z of the bottom's normal
}

TEST(StlFile, tetrahedron_as_text_has_its_lines) {
  const std::string text = written(stl::write, tetrahedron(), {.ascii = true});
  EXPECT_THAT(text, StartsWith("solid lumaknot\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\n"
                               "vertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"));
  EXPECT_EQ(testing::lines_with(text, "facet normal "), 4);
  EXPECT_TRUE(text.ends_with("vertex 0 0 0.1\nendloop\nendfacet\nendsolid lumaknot\n"));
}

TEST(StlFile, facet_normals_are_those_of_the_written_corners) {
  const TriangleMesh mesh = knot_mesh(testing::small_knot());
  const std::string bytes = written(stl::write, mesh);
  for (std::size_t at = 84; at < bytes.size(); at += 50) {
    std::array<Vec3d, 4> rows;  // the normal, then the corners
    for (std::size_t row = 0; row < 4; ++row) {
      const auto number = [&](std::size_t i) {
        return number_at<float>(bytes, at + 12 * row + 4 * i);
      };
      rows[row] = {number(0), number(1), number(2)};
    }
    const Vec3d normal = normalize(cross(rows[2] - rows[1], rows[3] - rows[1]));
    EXPECT_LT(length(rows[0] - normal), 6e-8);  // half a unit of 2^-24 in each component
  }
}

TEST(StlFile, facet_without_area_has_the_zero_normal) {
  TriangleMesh mesh = tetrahedron();
  mesh.triangles = {{0, 1, 1}};
  EXPECT_THAT(written(stl::write, mesh, {.ascii = true}), HasSubstr("facet normal 0 0 0\n"));
}

TEST(PovInclude, tetrahedron_has_its_lines_and_the_scenes_data) {
  const std::string text = written(povray::write_pov_include, tetrahedron());
  const std::string data =
      "  vertex_vectors { 4\n<0,0,0>\n<1,0,0>\n<0,1,0>\n<0,0,0.1>\n  }\n"
      "  normal_vectors { 4\n<-1,0,0>\n<1,0,0>\n<0,1,0>\n<0,0,1>\n  }\n"
      "  uv_vectors { 4\n<0,0>\n<1,0>\n<0,1>\n<0.25,1e-07>\n  }\n"
      "  face_indices { 4\n<0,2,1>\n<0,1,3>\n<0,3,2>\n<1,2,3>\n  }\n";
  EXPECT_EQ(povray::pov_mesh(tetrahedron()), data);
  EXPECT_THAT(text, HasSubstr("\n#declare lumaknot_mesh = mesh2 {\n" + data + "}\n"));
}

TEST(OmFile, positions_and_normals_are_doubles_and_texture_coordinates_float32) {
  const TriangleMesh mesh = tetrahedron();
  const std::string bytes = written(om::write, mesh);
  EXPECT_THAT(bytes, StartsWith("OMT"));
  std::string uvs;
  for (const Vec2d& uv : mesh.uvs) {
    append_float(uvs, float(uv.u));
    append_float(uvs, float(uv.v));
  }
  const auto raw = [](const Bulk<Vec3d>& all) {
    return std::string(reinterpret_cast<const char*>(all.data()), all.size() * sizeof(Vec3d));
  };
  EXPECT_THAT(bytes, HasSubstr(raw(mesh.positions)));
  EXPECT_THAT(bytes, HasSubstr(raw(mesh.normals)));
  EXPECT_THAT(bytes, HasSubstr(uvs));
}

TEST(MeshFormats, mesh_without_triangles_is_a_file_without_triangles) {
  const TriangleMesh none;
  EXPECT_EQ(written(obj::write, none), "");
  EXPECT_EQ(written(off::write, none), "OFF\n0 0 0\n");
  EXPECT_EQ(written(stl::write, none).size(), 84u);
  EXPECT_THAT(written(ply::write, none), HasSubstr("element vertex 0\n"));
}

/// Two adjacent quads, 0 1 2 3 and 1 4 5 2, their halves rotated differently.
TriangleMesh two_quads() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  mesh.normals.assign(6, {0, 0, 1});
  mesh.uvs.assign(6, {});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {5, 2, 4}, {1, 4, 2}};
  mesh.quads = true;
  return mesh;
}

TEST(MeshFormats, quads_are_written_when_requested) {
  const MeshFileOptions quads{.quads = true};
  EXPECT_THAT(written(off::write, two_quads(), quads), HasSubstr("6 2 0\n"));
  EXPECT_TRUE(written(off::write, two_quads(), quads).ends_with("4 0 1 2 3\n4 5 2 1 4\n"));
  EXPECT_TRUE(written(obj::write, two_quads(), quads)
                  .ends_with("f 1/1/1 2/2/2 3/3/3 4/4/4\nf 6/6/6 3/3/3 2/2/2 5/5/5\n"));
  const std::string text = written(ply::write, two_quads(), {.ascii = true, .quads = true});
  EXPECT_THAT(text, HasSubstr("element face 2\n"));
  EXPECT_TRUE(text.ends_with("4 0 1 2 3\n4 5 2 1 4\n"));
  const std::string bytes = written(ply::write, two_quads(), quads);
  EXPECT_EQ(bytes.substr(bytes.size() - 17), std::string("\4\5\0\0\0\2\0\0\0\1\0\0\0\4\0\0\0", 17));
}

}  // namespace
}  // namespace lumaknot
