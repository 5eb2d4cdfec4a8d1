#include "exporters/gltf/read.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "exporters/gltf/scene.h"
#include "tests/exporters/gltf/testing.h"

namespace lumaknot::gltf {
namespace {

using testing::corner_positions;
using ::testing::ElementsAre;
using testing::GltfParts;
using testing::Json;
using testing::read_bytes;
using testing::read_parts;
using testing::TemporaryFolder;
using testing::triangle_parts;

/// The triangle of triangle_parts() in our frame: glTF's (x, y, z) is our (x, -z, y).
const std::vector<Vec3d> kTriangle{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};

Json& primitive_of(GltfParts& parts) { return parts.json["meshes"][0]["primitives"][0]; }

Vec3d area_vector(const Polygons& polygons) {
  const std::vector<Vec3d> p = corner_positions(polygons);
  return cross(p[1] - p[0], p[2] - p[0]);
}

TEST(ReadGltf, a_written_mesh_comes_back_with_its_float32_values) {
  const TriangleMesh mesh = knot_mesh(testing::small_knot());
  std::ostringstream stream;
  write_glb(stream, mesh);
  const Polygons polygons = read_bytes(stream.str());
  ASSERT_EQ(polygons.positions.size(), mesh.positions.size());
  ASSERT_EQ(polygons.sizes.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(components(polygons.positions[i])[c], float(components(mesh.positions[i])[c]));
      EXPECT_EQ(components(polygons.normals[i])[c], float(components(mesh.normals[i])[c]));
    }
    EXPECT_EQ(polygons.uvs[i].u, float(mesh.uvs[i].u));
    EXPECT_EQ(1 - polygons.uvs[i].v, float(1 - mesh.uvs[i].v));  // the differences are exact
  }
  for (std::size_t c = 0; c < polygons.corners.size(); ++c) {
    const std::uint32_t vertex = mesh.triangles[c / 3][c % 3];
    EXPECT_EQ(polygons.corners[c].position, vertex);
    EXPECT_EQ(polygons.corners[c].normal, vertex);
    EXPECT_EQ(polygons.corners[c].uv, vertex);
  }
}

TEST(ReadGltf, an_exported_scene_is_read_with_its_other_files) {
  const Scene scene = testing::small_scene();
  const TemporaryFolder folder;
  write_package(folder.path(), gltf_package(scene, "my knot"), "--test");
  const Polygons beside = read_gltf(folder / "my knot.gltf", "mesh.file");
  const Polygons embedded = read_bytes(glb_package(scene, "knot").back().bytes);
  EXPECT_EQ(beside.sizes.size(), scene.mesh.triangles.size());
  EXPECT_EQ(beside.positions, embedded.positions);
  EXPECT_EQ(beside.uvs, embedded.uvs);
}

TEST(ReadGltf, y_up_becomes_z_up_and_v_points_upwards) {
  const Polygons polygons = read_parts(triangle_parts());
  EXPECT_EQ(corner_positions(polygons), kTriangle);
  EXPECT_EQ(polygons.normals[0], (Vec3d{0, -1, 0}));
  EXPECT_EQ(polygons.uvs, (std::vector<Vec2d>{{0, 0.25}, {1, 0.25}, {0, 0.75}}));
  EXPECT_THAT(polygons.sizes, ElementsAre(3u));
}

TEST(ReadGltf, embedded_buffers_are_read) {
  GltfParts parts = triangle_parts();
  parts.json["accessors"][0]["bufferView"] = 4;
  parts.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 36}});
  // 1, 2, 3 in float32, three times.
  parts.json["buffers"].push_back({{"byteLength", 36},
                                   {"uri",
                                    "data:application/octet-stream;base64,"
                                    "AACAPwAAAEAAAEBAAACAPwAAAEAAAEBAAACAPwAAAEAAAEBA"}});
  for (const Vec3d& p : read_parts(parts).positions) EXPECT_EQ(p, (Vec3d{1, -3, 2}));
}

TEST(ReadGltf, nodes_place_their_meshes_by_matrix_or_by_translation_rotation_and_scale) {
  GltfParts parts = triangle_parts();
  // A quarter turn about glTF's y, which is our z, of twice the size, from (10, 0, 0).
  const double half = std::sqrt(0.5);
  parts.json["nodes"] = {{{"translation", {10, 0, 0}}, {"children", {1}}},
                         {{"rotation", {0, half, 0, half}}, {"scale", {2, 2, 2}}, {"mesh", 0}}};
  const std::vector<Vec3d> by_parts = corner_positions(read_parts(parts));
  parts.json["nodes"] = {
      {{"mesh", 0}, {"matrix", {0, 0, -2, 0, 0, 2, 0, 0, 2, 0, 0, 0, 10, 0, 0, 1}}}};
  const std::vector<Vec3d> by_matrix = corner_positions(read_parts(parts));
  const std::vector<Vec3d> expected{{10, 0, 0}, {10, 2, 0}, {10, 0, 2}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(by_matrix[i], expected[i]);
    EXPECT_LT(length(by_parts[i] - expected[i]), 1e-14);  // sqrt(0.5)^2 is not quite 0.5
  }
}

TEST(ReadGltf, a_mesh_on_two_nodes_is_read_twice) {
  GltfParts parts = triangle_parts();
  parts.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 5, 0}}}};
  parts.json["scenes"][0]["nodes"] = {0, 1};
  const std::vector<Vec3d> corners = corner_positions(read_parts(parts));
  ASSERT_EQ(corners.size(), 6u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(corners[3 + i], corners[i] + Vec3d({0, 0, 5}));
}

TEST(ReadGltf, a_mirror_turns_the_winding_and_keeps_the_normal_outside) {
  GltfParts parts = triangle_parts();
  parts.json["nodes"][0]["scale"] = {-2, 1, 3};
  const Polygons polygons = read_parts(parts);
  EXPECT_GT(dot(area_vector(polygons), polygons.normals[0]), 0);
  EXPECT_LT(polygons.normals[0].y, 0);
}

TEST(ReadGltf, normals_stay_perpendicular_under_uneven_scales) {
  GltfParts parts = triangle_parts();
  parts.json["nodes"][0] = {
      {"mesh", 0}, {"rotation", {0.1, 0.2, 0.3, 0.9}}, {"scale", {1, 4, 0.5}}};
  const Polygons polygons = read_parts(parts);
  const Vec3d area = area_vector(polygons);
  const double sine = length(cross(normalize(area), normalize(polygons.normals[0])));
  EXPECT_LT(sine, 1e-14);  // roundings of double
}

TEST(ReadGltf, without_a_scene_all_nodes_are_read_otherwise_only_the_default_scene) {
  GltfParts parts = triangle_parts();
  parts.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"children", {2}}}, {{"mesh", 0}}};
  parts.json["scenes"] = {{{"nodes", {1}}}, {{"nodes", {0}}}};
  const auto triangles = [&] { return read_parts(parts).sizes.size(); };
  EXPECT_EQ(triangles(), 2u);
  parts.json["scene"] = 1;
  EXPECT_EQ(triangles(), 1u);
  parts.json.erase("scene");
  EXPECT_EQ(triangles(), 2u);
  parts.json.erase("scenes");
  EXPECT_EQ(triangles(), 3u);
}

TEST(ReadGltf, strips_and_fans_keep_their_winding) {
  GltfParts parts = triangle_parts();
  const std::size_t square = add_accessor(
      parts, testing::bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}), 5126, 4, "VEC3");
  primitive_of(parts) = {{"attributes", {{"POSITION", square}}}, {"mode", 5}};
  const Polygons strip = read_parts(parts);
  EXPECT_EQ(strip.sizes.size(), 2u);
  for (const Vec3d& n : strip.normals) EXPECT_EQ(n, (Vec3d{0, -1, 0}));
  primitive_of(parts)["mode"] = 6;
  primitive_of(parts)["indices"] =
      add_accessor(parts, testing::bytes_of<std::uint8_t>({0, 1, 3, 2}), 5121, 4, "SCALAR");
  const Polygons fan = read_parts(parts);
  EXPECT_EQ(fan.sizes.size(), 2u);
  for (const Vec3d& n : fan.normals) EXPECT_EQ(n, (Vec3d{0, -1, 0}));
}

TEST(ReadGltf, points_and_lines_are_left_out) {
  GltfParts parts = triangle_parts();
  Json lines = primitive_of(parts);
  lines["mode"] = 1;
  parts.json["meshes"][0]["primitives"].push_back(lines);
  EXPECT_EQ(read_parts(parts).sizes.size(), 1u);
}

TEST(ReadGltf, triangles_without_indices_and_normals_are_flat) {
  GltfParts parts = triangle_parts();
  primitive_of(parts) = {{"attributes", {{"POSITION", 0}}}};
  const Polygons polygons = read_parts(parts);
  EXPECT_EQ(corner_positions(polygons), kTriangle);
  for (const PolygonCorner& corner : polygons.corners) {
    EXPECT_EQ(polygons.normals[corner.normal], (Vec3d{0, -1, 0}));
    EXPECT_EQ(corner.uv, kNoIndex);
  }
}

TEST(ReadGltf, indices_of_every_width_are_read) {
  const auto read_as = [](const std::string& bytes, int component) {
    GltfParts parts = triangle_parts();
    primitive_of(parts)["indices"] = add_accessor(parts, bytes, component, 3, "SCALAR");
    return corner_positions(read_parts(parts));
  };
  const std::vector<Vec3d> turned{kTriangle[2], kTriangle[0], kTriangle[1]};
  EXPECT_EQ(read_as(testing::bytes_of<std::uint8_t>({2, 0, 1}), 5121), turned);
  EXPECT_EQ(read_as(testing::bytes_of<std::uint16_t>({2, 0, 1}), 5123), turned);
  EXPECT_EQ(read_as(testing::bytes_of<std::uint32_t>({2, 0, 1}), 5125), turned);
}

TEST(ReadGltf, integer_texture_coordinates_are_fractions) {
  const auto read_as = [](const std::string& bytes, int component) {
    GltfParts parts = triangle_parts();
    const std::size_t uvs = add_accessor(parts, bytes, component, 3, "VEC2");
    parts.json["accessors"][uvs]["normalized"] = true;
    primitive_of(parts)["attributes"]["TEXCOORD_0"] = uvs;
    return read_parts(parts).uvs;
  };
  const std::vector<Vec2d> expected{{0, 1}, {1, 0}, {0.2, 0.4}};
  for (const auto& uvs :
       {read_as(testing::bytes_of<std::uint8_t>({0, 0, 255, 255, 51, 153}), 5121),
        read_as(testing::bytes_of<std::uint16_t>({0, 0, 65535, 65535, 13107, 39321}), 5123)}) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(uvs[i].u, expected[i].u, 1e-15);  // one rounding
      EXPECT_NEAR(uvs[i].v, expected[i].v, 1e-15);
    }
  }
}

TEST(ReadGltf, interleaved_vertices_are_read_by_their_stride) {
  GltfParts parts = triangle_parts();
  std::vector<float> rows;
  for (int i = 0; i < 3; ++i) {
    rows.insert(rows.end(), {float(i), 0, float(i * i), 0, 0, 1, 7, 7});
  }
  const std::size_t positions = add_accessor(parts, testing::bytes_of(rows), 5126, 3, "VEC3");
  parts.json["bufferViews"][4]["byteStride"] = 32;
  Json normals = parts.json["accessors"][positions];
  normals["byteOffset"] = 12;
  parts.json["accessors"].push_back(normals);
  primitive_of(parts)["attributes"] = {{"POSITION", positions}, {"NORMAL", positions + 1}};
  const Polygons polygons = read_parts(parts);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(polygons.positions[std::size_t(i)], (Vec3d{double(i), -double(i * i), 0}));
    EXPECT_EQ(polygons.normals[std::size_t(i)], (Vec3d{0, -1, 0}));
  }
}

TEST(ReadGltf, quantised_positions_are_read) {
  GltfParts parts = triangle_parts();
  parts.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const std::size_t positions = add_accessor(
      parts, testing::bytes_of<std::int16_t>({0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, 0, 0}), 5122,
      3, "VEC3");
  parts.json["accessors"][positions]["normalized"] = true;
  parts.json["bufferViews"][4]["byteStride"] = 8;
  primitive_of(parts)["attributes"]["POSITION"] = positions;
  EXPECT_EQ(corner_positions(read_parts(parts)),
            (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}));
}

TEST(ReadGltf, extras_and_images_are_ignored_however_deep_or_wrong) {
  GltfParts parts = triangle_parts();
  parts.json["images"] = {{{"uri", "../../none.png"}}, 7};
  parts.json["materials"] = "no list";
  std::string text = parts.json.dump();
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  text.insert(1, "\"extras\": " + deep + ", ");
  text.insert(1, "\"extensions\": {\"nodes\": " + deep + "}, ");
  // As .gltf: the buffer must be in the same folder.
  text.replace(text.find(R"("byteLength":102)"), 16, R"("byteLength":102,"uri":"a%20b.bin")");
  const TemporaryFolder folder;
  folder.file("a b.bin", parts.binary);
  EXPECT_EQ(read_gltf(folder.file("deep.gltf", text), "mesh.file").sizes.size(), 1u);
}

}  // namespace
}  // namespace lumaknot::gltf
