#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/exporters/mesh/testing.h"

namespace lumaknot {
namespace {

using testing::area;
using testing::area_vector;
using testing::expect_consistent;
using ::testing::HasSubstr;
using testing::kCubeObj;
using testing::kQuadObj;
using testing::TemporaryFolder;

TriangleMesh read(const TemporaryFolder& folder, std::string_view name, std::string_view text,
                  bool needs_uvs = false) {
  return read_mesh(folder.file(name, text), needs_uvs, "mesh.file");
}

TEST(ReadMesh, quads_become_two_triangles_wound_alike) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read(folder, "quad.obj", kQuadObj, true);
  expect_consistent(mesh);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(area(mesh), 2);
  for (const Triangle& t : mesh.triangles) EXPECT_GT(area_vector(mesh, t).z, 0);
}

TEST(ReadMesh, texture_coordinates_keep_v_upwards) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read(folder, "quad.obj", kQuadObj, true);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_EQ(mesh.uvs[i], (Vec2d{mesh.positions[i].x / 2, mesh.positions[i].y}));
  }
}

TEST(ReadMesh, concave_polygons_keep_their_area) {
  const TemporaryFolder folder;
  const TriangleMesh mesh =
      read(folder, "arrow.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\nf 1 2 3 4\n");
  EXPECT_NEAR(area(mesh), 4, 1e-12);  // the shoelace formula, in double
}

TEST(ReadMesh, missing_normals_are_made_smooth) {
  const TemporaryFolder folder;
  const TriangleMesh mesh =
      read(folder, "octahedron.obj",
           "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
           "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n");
  expect_consistent(mesh);
  EXPECT_EQ(mesh.positions.size(), 6u);  // smooth: one normal per corner, so one vertex
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_NEAR(length(mesh.normals[i] - mesh.positions[i]), 0, 1e-12);  // by symmetry
  }
}

TEST(ReadMesh, hard_edges_are_kept) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read(folder, "cube.obj", kCubeObj);
  expect_consistent(mesh);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.positions.size(), 24u);  // each corner once for each of its three faces
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t i : t) {
      EXPECT_GT(dot(mesh.normals[i], normalize(area_vector(mesh, t))), 0.999);
    }
  }
}

TEST(ReadMesh, missing_texture_coordinates_are_zero_where_none_are_needed) {
  const TemporaryFolder folder;
  for (const Vec2d& uv : read(folder, "cube.obj", kCubeObj).uvs) EXPECT_EQ(uv, Vec2d{});
}

TEST(ReadMesh, missing_texture_coordinates_are_refused_with_a_remedy_where_they_are_needed) {
  const TemporaryFolder folder;
  const std::string error = error_of([&] { read(folder, "cube.obj", kCubeObj, true); });
  EXPECT_THAT(error, HasSubstr("mesh.file"));
  EXPECT_THAT(error, HasSubstr("cube.obj has no texture coordinates"));
  EXPECT_THAT(error, HasSubstr("color"));
}

TEST(ReadMesh, a_texture_seam_keeps_both_coordinates) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read(folder, "seam.obj",
                                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                 "vt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.5\n"
                                 "f 1/1 2/2 3/3\nf 1/4 3/3 4/4\n",
                                 true);
  EXPECT_EQ(mesh.positions.size(), 5u);  // (0, 0, 0) twice
}

TEST(ReadMesh, stl_is_read) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read(folder, "one.stl",
                                 "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                 "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n");
  expect_consistent(mesh);
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(area(mesh), 0.5);
  EXPECT_EQ(mesh.normals[0], (Vec3d{0, 0, 1}));
}

TEST(ReadMesh, off_is_read) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read(folder, "tetrahedron.off",
                                 "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                 "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  expect_consistent(mesh);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_NEAR(area(mesh), 1.5 + std::sqrt(3.0) / 2, 1e-12);
}

TEST(ReadMesh, several_objects_become_one_mesh) {
  const TemporaryFolder folder;
  const TriangleMesh mesh =
      read(folder, "two.obj",
           "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf 4 5 6\n");
  expect_consistent(mesh);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(area(mesh), 1);
}

TEST(ReadMesh, files_that_are_not_meshes_are_refused_naming_the_label_and_the_file) {
  const TemporaryFolder folder;
  const std::pair<const char*, std::string> cases[] = {
      {"empty.obj", ""},
      {"garbage.obj", "not a mesh at all, only words\n"},
      {"garbage.ply", "not a mesh at all, only words\n"},
      {"garbage.off", "not a mesh at all, only words\n"},
      {"garbage.stl", "not a mesh at all, only words\n"},
      {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
      {"lines.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\n"},
  };
  for (const auto& [name, text] : cases) {
    const std::string error = error_of([&, &n = name, &t = text] { read(folder, n, t); });
    EXPECT_THAT(error, HasSubstr("mesh.file")) << name;
    EXPECT_THAT(error, HasSubstr(name)) << name;
  }
}

TEST(ReadMesh, missing_file_is_refused_naming_the_label_and_the_file) {
  const TemporaryFolder folder;
  const std::string error =
      error_of([&] { read_mesh(folder / "missing.obj", false, "mesh.file"); });
  EXPECT_THAT(error, HasSubstr("mesh.file"));
  EXPECT_THAT(error, HasSubstr("missing.obj"));
}

TEST(ReadMesh, a_folder_and_a_file_of_another_kind_are_refused) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder.obj");
  EXPECT_THAT(error_of([&] { read_mesh(folder / "folder.obj", false, "mesh.file"); }),
              HasSubstr("it is a folder"));
  EXPECT_THAT(error_of([&] { read(folder, "knot.png", kQuadObj); }),
              HasSubstr("knot.png must end in one of .obj .ply .stl .off .om .pov .inc"));
  for (const char* name : {"a.obj", "a.ply", "a.stl", "a.off", "a.om", "a.pov"}) {
    const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\1\0\0\0\1\0", 24);
    EXPECT_THAT(error_of([&] { read(folder, name, png); }), HasSubstr(name));
  }
}

TEST(ReadMesh, the_extension_gives_the_format_in_capitals_too) {
  const TemporaryFolder folder;
  EXPECT_EQ(read(folder, "KNOT.OBJ", kQuadObj).triangles.size(), 2u);
  EXPECT_EQ(read(folder, "knot.inc", testing::kTetrahedronPov).triangles.size(), 4u);
}

TEST(ReadMesh, every_format_is_read_by_its_extension) {
  const TemporaryFolder folder;
  for (const testing::MeshSample& sample : testing::mesh_samples()) {
    expect_consistent(read(folder, std::string(sample.name) + sample.ending, sample.bytes));
  }
}

TEST(ReadMesh, index_beyond_the_vertices_is_refused_with_its_file_and_line) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of([&] { read(folder, "bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"); }),
              HasSubstr("bad.obj, line 4: vertex 9 does not exist, the file has 3"));
}

/// Reads in a process of its own, which exits with 0 when the file was refused: a reader that hangs
/// or crashes must not affect the other tests.
void read_and_exit(std::string_view name, std::string_view text) {
  constexpr unsigned kSeconds = 10;  // hundreds of times as long as a refusal
  ::alarm(kSeconds);
  std::string error;
  {
    const TemporaryFolder folder;
    error = error_of([&] { read(folder, name, text); });
  }
  std::_Exit(error.find("mesh.file") == error.npos ? 1 : 0);
}

/// The readers' threads rule out a plain fork.
class ReadMeshDeathTest : public ::testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(ReadMeshDeathTest, ply_cut_within_its_header_is_refused) {
  EXPECT_EXIT(
      read_and_exit("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"),
      ::testing::ExitedWithCode(0), "");
}

TEST_F(ReadMeshDeathTest, ply_index_beyond_the_vertices_is_refused) {
  EXPECT_EXIT(read_and_exit("far.ply",
                            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                            "property float y\nproperty float z\nelement face 1\n"
                            "property list uchar int vertex_indices\nend_header\n"
                            "0 0 0\n1 0 0\n0 1 0\n3 0 1 90000000\n"),
              ::testing::ExitedWithCode(0), "");
}

TEST(ReadMesh, numbers_that_are_not_finite_are_refused) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of([&] { read(folder, "nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); }),
              HasSubstr("mesh.file"));
}

}  // namespace
}  // namespace lumaknot
