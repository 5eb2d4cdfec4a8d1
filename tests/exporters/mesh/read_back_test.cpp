// Written mesh files, read by OpenMesh.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>

#include "exporters/mesh/file.h"
#include "tests/exporters/testing.h"

namespace lumaknot {
namespace {

using ::testing::Contains;
using testing::TemporaryFolder;

TriangleMesh small_mesh() { return knot_mesh(testing::small_knot()); }

struct ReadTraits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = OpenMesh::Vec2d;
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::TexCoord2D);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::TexCoord2D);
};
using ReadMesh = OpenMesh::PolyMesh_ArrayKernelT<ReadTraits>;
using ReadOptions = OpenMesh::IO::Options;

/// An independent reader.
ReadMesh read_by_open_mesh(const std::filesystem::path& path, ReadOptions options = {}) {
  omlog().disable();
  ReadMesh mesh;
  if (!OpenMesh::IO::read_mesh(mesh, path.string(), options)) throw std::runtime_error("unread");
  return mesh;
}

/// The halfedges that point to the corners of face `index`, in the file's order.
std::vector<ReadMesh::HalfedgeHandle> corners(const ReadMesh& mesh, std::size_t index) {
  std::vector<ReadMesh::HalfedgeHandle> halfedges;
  const auto first = mesh.halfedge_handle(ReadMesh::FaceHandle(int(index)));
  auto halfedge = mesh.prev_halfedge_handle(first);
  do {
    halfedges.push_back(halfedge);
    halfedge = mesh.next_halfedge_handle(halfedge);
  } while (halfedge != mesh.prev_halfedge_handle(first));
  return halfedges;
}

Vec3d to_vec(const OpenMesh::Vec3d& v) { return {v[0], v[1], v[2]}; }
Vec3<float> narrowed(const Vec3d& v) { return {float(v.x), float(v.y), float(v.z)}; }
Vec3<float> position(const ReadMesh& mesh, ReadMesh::HalfedgeHandle corner) {
  return narrowed(to_vec(mesh.point(mesh.to_vertex_handle(corner))));
}

/// Calls `check(read's halfedge, written's vertex)` for every corner of every triangle. A triangle
/// may begin with another corner, as in OM files, but is not reversed.
template <class Check>
void for_each_corner(const ReadMesh& read, const TriangleMesh& written, Check check) {
  ASSERT_EQ(read.n_faces(), written.triangles.size());
  for (std::size_t t = 0; t < written.triangles.size(); ++t) {
    auto halfedges = corners(read, t);
    ASSERT_EQ(halfedges.size(), 3u);
    const Vec3<float> first = narrowed(written.positions[written.triangles[t][0]]);
    const auto same = [&](auto halfedge) { return position(read, halfedge) == first; };
    std::rotate(halfedges.begin(), std::ranges::find_if(halfedges, same), halfedges.end());
    for (std::size_t c = 0; c < 3; ++c) check(halfedges[c], written.triangles[t][c]);
  }
}

int boundary_edges(const ReadMesh& mesh) {
  return int(std::ranges::count_if(mesh.edges(), [&](auto e) { return mesh.is_boundary(e); }));
}

int euler_characteristic(const ReadMesh& mesh) {
  return int(mesh.n_vertices()) - int(mesh.n_edges()) + int(mesh.n_faces());
}

struct FormatCase {
  const char* name;
  const char* extension;
  bool ascii;
  bool closes_seams;  ///< a seam's vertices share a position
};
constexpr FormatCase kCases[] = {
    {"obj", ".obj", false, true},      {"ply", ".ply", false, false},
    {"ply_text", ".ply", true, false}, {"stl", ".stl", false, true},
    {"stl_text", ".stl", true, true},  {"off", ".off", false, true},
    {"om", ".om", false, false},
};

class ReadFormat : public ::testing::TestWithParam<FormatCase> {};
INSTANTIATE_TEST_SUITE_P(, ReadFormat, ::testing::ValuesIn(kCases),
                         [](const auto& format) { return std::string(format.param.name); });

TEST_P(ReadFormat, triangles_and_positions_survive_exactly) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("knot") + GetParam().extension);
  const TriangleMesh mesh = small_mesh();
  write_mesh(path, mesh, {.ascii = GetParam().ascii}, "--output");
  const ReadMesh read = read_by_open_mesh(path);
  for_each_corner(read, mesh, [&](auto halfedge, std::uint32_t vertex) {
    EXPECT_EQ(position(read, halfedge), narrowed(mesh.positions[vertex]));
  });
}

TEST_P(ReadFormat, surface_is_closed_and_of_genus_one_where_seams_close) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("knot") + GetParam().extension);
  write_mesh(path, small_mesh(), {.ascii = GetParam().ascii}, "--output");
  const ReadMesh read = read_by_open_mesh(path);
  if (GetParam().closes_seams) {
    EXPECT_EQ(boundary_edges(read), 0);
    EXPECT_EQ(euler_characteristic(read), 0);
  } else {
    EXPECT_EQ(boundary_edges(read), 2 * (24 + 6));  // cut open along both seams: a rectangle
    EXPECT_EQ(euler_characteristic(read), 1);
  }
}

/// Formats with normals and texture coordinates.
class FullFormat : public ReadFormat {};
INSTANTIATE_TEST_SUITE_P(, FullFormat,
                         ::testing::Values(kCases[0], kCases[1], kCases[2], kCases[6]),
                         [](const auto& format) { return std::string(format.param.name); });

TEST_P(FullFormat, normals_and_texture_coordinates_survive_exactly) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("knot") + GetParam().extension);
  const TriangleMesh mesh = small_mesh();
  write_mesh(path, mesh, {.ascii = GetParam().ascii}, "--output");
  const bool on_corners = path.extension() == ".obj";
  ReadOptions options = ReadOptions::VertexNormal;
  options += on_corners ? ReadOptions::FaceTexCoord : ReadOptions::VertexTexCoord;
  const ReadMesh read = read_by_open_mesh(path, options);
  for_each_corner(read, mesh, [&](auto halfedge, std::uint32_t vertex) {
    const auto point = read.to_vertex_handle(halfedge);
    EXPECT_EQ(narrowed(to_vec(read.normal(point))), narrowed(mesh.normals[vertex]));
    const auto uv = on_corners ? read.texcoord2D(halfedge) : read.texcoord2D(point);
    EXPECT_EQ(float(uv[0]), float(mesh.uvs[vertex].u));
    EXPECT_EQ(float(uv[1]), float(mesh.uvs[vertex].v));
  });
}

class QuadFormat : public ReadFormat {};
INSTANTIATE_TEST_SUITE_P(, QuadFormat,
                         ::testing::Values(kCases[0], kCases[1], kCases[2], kCases[5]),
                         [](const auto& format) { return std::string(format.param.name); });

TEST_P(QuadFormat, quads_are_the_triangles_in_pairs) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("knot") + GetParam().extension);
  TriangleMesh mesh = small_mesh();
  mesh.quads = true;
  write_mesh(path, mesh, {.ascii = GetParam().ascii, .quads = true}, "--output");
  const ReadMesh read = read_by_open_mesh(path);
  ASSERT_EQ(read.n_faces(), mesh.triangles.size() / 2);
  EXPECT_EQ(euler_characteristic(read), GetParam().closes_seams ? 0 : 1);
  for (std::size_t q = 0; q < read.n_faces(); ++q) {
    std::vector<Vec3<float>> quad;
    for (const auto halfedge : corners(read, q)) {
      quad.push_back(position(read, halfedge));
    }
    ASSERT_EQ(quad.size(), 4u);
    for (std::size_t half = 0; half < 2; ++half) {
      for (const std::uint32_t vertex : mesh.triangles[2 * q + half]) {
        EXPECT_THAT(quad, Contains(narrowed(mesh.positions[vertex])));
      }
    }
  }
}

}  // namespace
}  // namespace lumaknot
