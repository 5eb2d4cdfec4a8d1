/// Shared by the tests of mesh files: reading texts, measurements of the result, a valid file of
/// each format.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <array>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "exporters/mesh/file.h"
#include "exporters/obj/format.h"
#include "exporters/off/format.h"
#include "exporters/om/format.h"
#include "exporters/ply/format.h"
#include "exporters/povray/format.h"
#include "exporters/povray/scene.h"
#include "exporters/stl/format.h"
#include "meshgen/closed_mesh.h"
#include "tests/exporters/testing.h"

namespace lumaknot::testing {

using MeshReader = Polygons (*)(std::string_view bytes, std::string_view name);

/// The result of `reader` on `bytes`, called "mesh.file knot".
inline TriangleMesh read_bytes(MeshReader reader, std::string_view bytes, bool needs_uvs = false) {
  return triangulated(reader(bytes, "mesh.file knot"), needs_uvs, "mesh.file knot");
}

inline std::string refusal(MeshReader reader, std::string_view bytes, bool needs_uvs = false) {
  return error_of([&] { read_bytes(reader, bytes, needs_uvs); });
}

inline Vec3d area_vector(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3d a = mesh.positions[t[0]];
  return cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a) / 2.0;
}

inline double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += length(area_vector(mesh, t));
  return sum;
}

inline double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += dot(mesh.positions[t[0]], area_vector(mesh, t)) / 3;
  }
  return sum;
}

inline void expect_consistent(const TriangleMesh& mesh) {
  ASSERT_FALSE(mesh.triangles.empty());
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t i : t) ASSERT_LT(i, mesh.positions.size());
  }
  for (const Vec3d& p : mesh.positions) ASSERT_TRUE(is_finite(p));
  for (const Vec2d& uv : mesh.uvs) ASSERT_TRUE(std::isfinite(uv.u) && std::isfinite(uv.v));
  // Normalised in double: a few roundings of 1e-16.
  for (const Vec3d& n : mesh.normals) ASSERT_NEAR(length(n), 1, 1e-12);
}

/// The bytes of `value` in the order of the file.
template <class T>
std::string raw(T value, bool big_endian = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

/// A tetrahedron's corners and faces, wound outwards.
inline constexpr std::array<std::array<float, 3>, 4> kTetrahedron{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
inline constexpr std::array<std::array<std::int32_t, 3>, 4> kTetrahedronFaces{
    {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

inline constexpr const char* kQuadObj =
    "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "f 1/1 2/2 3/3 4/4\n";

/// A cube about the origin with one normal per face and no texture coordinates.
inline constexpr const char* kCubeObj =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 1 0 0\nvn 0 1 0\nvn -1 0 0\n"
    "f 1//1 4//1 3//1 2//1\nf 5//2 6//2 7//2 8//2\nf 1//3 2//3 6//3 5//3\n"
    "f 2//4 3//4 7//4 6//4\nf 3//5 4//5 8//5 7//5\nf 4//6 1//6 5//6 8//6\n";

inline constexpr const char* kTetrahedronOff =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

inline constexpr const char* kTetrahedronPly =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nelement face 4\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

inline constexpr const char* kTetrahedronPov =
    "// One mesh.\nmesh2 {\n  vertex_vectors { 4, <0,0,0>, <1,0,0>, <0,1,0>, <0,0,1> }\n"
    "  face_indices { 4, <0,2,1>, <0,1,3>,\n    <0,3,2>, <1,2,3> }\n  pigment { rgb 1 }\n}\n";

inline std::string tetrahedron_stl_text() {
  std::string text = "solid made by hand\n";
  for (const auto& face : kTetrahedronFaces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::int32_t i : face) {
      const auto& p = kTetrahedron[std::size_t(i)];
      text += fmt::format("vertex {} {} {}\n", p[0], p[1], p[2]);
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid made by hand\n";
}

inline std::string tetrahedron_stl() {
  std::string bytes = std::string(80, ' ') + raw(std::uint32_t(4));
  for (const auto& face : kTetrahedronFaces) {
    bytes += std::string(12, '\0');  // no normal
    for (const std::int32_t i : face) {
      for (const float c : kTetrahedron[std::size_t(i)]) bytes += raw(c);
    }
    bytes += raw(std::uint16_t(0));
  }
  return bytes;
}

inline std::string tetrahedron_ply(bool big_endian) {
  std::string bytes = fmt::format(
      "ply\nformat binary_{}_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\n"
      "property short z\nproperty uchar red\nelement face 4\nproperty list uint uint8 extra\n"
      "property list uchar int vertex_index\nend_header\n",
      big_endian ? "big" : "little");
  for (const auto& p : kTetrahedron) {
    bytes += raw(double(p[0]), big_endian) + raw(p[1], big_endian);
    bytes += raw(std::int16_t(p[2]), big_endian) + "\x7f";
  }
  for (const auto& face : kTetrahedronFaces) {
    bytes += raw(std::uint32_t(2), big_endian) + "ab" + raw(std::uint8_t(3));
    for (const std::int32_t i : face) bytes += raw(i, big_endian);
  }
  return bytes;
}

/// `mesh` as written by OpenMesh's own writer for `extension`.
template <class Mesh>
std::string written_by_openmesh(const Mesh& mesh, std::string_view extension,
                                const OpenMesh::IO::Options& options) {
  std::ostringstream stream(std::ios::binary);
  constexpr int kDigits = 9;  // enough for any float32
  EXPECT_TRUE(OpenMesh::IO::write_mesh(mesh, stream, std::string(extension), options, kDigits));
  return stream.str();
}

inline KnotSpec tiny_spec() {
  KnotSpec knot;
  knot.segments = 5;
  knot.sides = 3;
  return knot;
}

inline ClosedMesh tiny_knot() { return closed_mesh(tiny_spec(), knot_mesh(tiny_spec())); }

/// Face by face, corner by corner. The written values are float32, or nine digits.
inline void expect_same_as_knot(const TriangleMesh& mesh, const ClosedMesh& knot,
                                bool has_normals) {
  ASSERT_EQ(mesh.triangles.size(), knot.n_faces());
  for (const auto face : knot.faces()) {
    const Triangle& t = mesh.triangles[std::size_t(face.idx())];
    std::size_t corner = 0;
    for (const auto v : knot.fv_range(face)) {
      const auto &p = knot.point(v), &n = knot.normal(v);
      // Half a unit of 2^-23 for numbers below 2; a normal is renormalised.
      EXPECT_LT(length(mesh.positions[t[corner]] - Vec3d{p[0], p[1], p[2]}), 3e-7);
      if (has_normals) {
        EXPECT_LT(length(mesh.normals[t[corner]] - Vec3d{n[0], n[1], n[2]}), 3e-7);
      }
      ++corner;
    }
  }
}

inline std::string knot_om() {
  using OpenMesh::IO::Options;
  return written_by_openmesh(
      tiny_knot(), ".om", Options(Options::Binary | Options::VertexNormal | Options::FaceTexCoord));
}

inline std::string knot_pov() {
  return "mesh2 {\n" + povray::pov_mesh(knot_mesh(tiny_spec())) + "  no_shadow\n}\n";
}

struct MeshSample {
  const char *name, *ending;
  MeshReader reader;
  std::string bytes;
};

/// A valid file of each format and encoding.
inline std::vector<MeshSample> mesh_samples() {
  return {
      {"quad_obj", ".obj", obj::read, kQuadObj},
      {"cube_obj", ".obj", obj::read, kCubeObj},
      {"ply_text", ".ply", ply::read, kTetrahedronPly},
      {"ply_little", ".ply", ply::read, tetrahedron_ply(false)},
      {"ply_big", ".ply", ply::read, tetrahedron_ply(true)},
      {"stl_text", ".stl", stl::read, tetrahedron_stl_text()},
      {"stl", ".stl", stl::read, tetrahedron_stl()},
      {"off", ".off", off::read, kTetrahedronOff},
      {"om", ".om", om::read, knot_om()},
      {"pov", ".pov", povray::read_pov, kTetrahedronPov},
      {"knot_pov", ".pov", povray::read_pov, knot_pov()},
  };
}

}  // namespace lumaknot::testing
