#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "exporters/gltf/scene.h"
#include "tests/exporters/gltf/testing.h"

namespace lumaknot::gltf {
namespace {

using testing::GltfParts;
using ::testing::HasSubstr;
using testing::Json;
using testing::value_at;

std::string glb(const TriangleMesh& mesh) {
  std::ostringstream stream;
  write_glb(stream, mesh);
  return stream.str();
}

TriangleMesh small_mesh() { return knot_mesh(testing::small_knot()); }

/// `count` vertices on a line, and triangles that use the first and the last.
TriangleMesh mesh_of(std::size_t count) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < count; ++i) mesh.positions.push_back({double(i), 0, 1});
  mesh.normals.assign(count, {0, 0, 1});
  mesh.uvs.assign(count, {});
  mesh.triangles = {{0, 1, std::uint32_t(count - 1)}};
  return mesh;
}

/// The bytes of an accessor's view.
std::string_view view_of(const GltfParts& parts, std::size_t accessor) {
  const Json& view =
      parts.json["bufferViews"][parts.json["accessors"][accessor]["bufferView"].get<std::size_t>()];
  return std::string_view(parts.binary)
      .substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>());
}

std::size_t accessor_of(const GltfParts& parts, const char* attribute) {
  return parts.json["meshes"][0]["primitives"][0]["attributes"][attribute].get<std::size_t>();
}

TEST(WriteGlb, header_and_chunks_are_those_of_the_specification) {
  const std::string bytes = glb(small_mesh());
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(value_at<std::uint32_t>(bytes, 4), 2u);
  EXPECT_EQ(value_at<std::uint32_t>(bytes, 8), bytes.size());
  const auto json_size = value_at<std::uint32_t>(bytes, 12);
  EXPECT_EQ(json_size % 4, 0u);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(bytes.substr(24 + json_size, 4), std::string("BIN\0", 4));
  EXPECT_EQ(value_at<std::uint32_t>(bytes, 20 + json_size), bytes.size() - 28 - json_size);
  EXPECT_EQ(bytes.size() % 4, 0u);
}

TEST(WriteGlb, arrays_hold_the_mesh_in_float32_with_v_downwards) {
  const TriangleMesh mesh = small_mesh();
  const GltfParts parts = testing::parts_of(glb(mesh));
  const std::string_view positions = view_of(parts, accessor_of(parts, "POSITION"));
  const std::string_view normals = view_of(parts, accessor_of(parts, "NORMAL"));
  const std::string_view uvs = view_of(parts, accessor_of(parts, "TEXCOORD_0"));
  ASSERT_EQ(positions.size(), 12 * mesh.positions.size());
  ASSERT_EQ(normals.size(), 12 * mesh.positions.size());
  ASSERT_EQ(uvs.size(), 8 * mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(value_at<float>(positions, 12 * i + 4 * c),
                float(components(mesh.positions[i])[c]));
      EXPECT_EQ(value_at<float>(normals, 12 * i + 4 * c), float(components(mesh.normals[i])[c]));
    }
    EXPECT_EQ(value_at<float>(uvs, 8 * i), float(mesh.uvs[i].u));
    EXPECT_EQ(value_at<float>(uvs, 8 * i + 4), float(1 - mesh.uvs[i].v));
  }
}

TEST(WriteGlb, bounds_are_those_of_the_float32_values) {
  const TriangleMesh mesh = small_mesh();
  const GltfParts parts = testing::parts_of(glb(mesh));
  const Json& accessor = parts.json["accessors"][accessor_of(parts, "POSITION")];
  for (std::size_t c = 0; c < 3; ++c) {
    float min = INFINITY, greatest = -INFINITY;
    for (const Vec3d& p : mesh.positions) {
      min = std::min(min, float(components(p)[c]));
      greatest = std::max(greatest, float(components(p)[c]));
    }
    EXPECT_EQ(accessor["min"][c].get<double>(), double(min));
    EXPECT_EQ(accessor["max"][c].get<double>(), double(greatest));
  }
}

TEST(WriteGlb, indices_have_16_bits_up_to_65535_vertices_and_32_beyond) {
  for (const std::size_t count : {std::size_t(3), std::size_t(65535), std::size_t(65536)}) {
    const GltfParts parts = testing::parts_of(glb(mesh_of(count)));
    const auto index = parts.json["meshes"][0]["primitives"][0]["indices"].get<std::size_t>();
    const bool is_short = count <= 65535;
    EXPECT_EQ(parts.json["accessors"][index]["componentType"], is_short ? 5123 : 5125) << count;
    const std::string_view indices = view_of(parts, index);
    ASSERT_EQ(indices.size(), is_short ? 6u : 12u);
    EXPECT_EQ(is_short ? value_at<std::uint16_t>(indices, 4) : value_at<std::uint32_t>(indices, 8),
              count - 1);
  }
}

TEST(WriteGlb, tangents_are_written_with_their_sign_if_present) {
  TriangleMesh mesh = mesh_of(3);
  EXPECT_FALSE(
      testing::parts_of(glb(mesh)).json["meshes"][0]["primitives"][0]["attributes"].contains(
          "TANGENT"));
  mesh.tangents = {{{1, 0, 0}, 1}, {{0, 1, 0}, -1}, {{-1, 0, 0}, 1}};
  const GltfParts parts = testing::parts_of(glb(mesh));
  const std::string_view tangents = view_of(parts, accessor_of(parts, "TANGENT"));
  ASSERT_EQ(tangents.size(), 48u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(value_at<float>(tangents, 16 * i), mesh.tangents[i].direction.x);
    EXPECT_EQ(value_at<float>(tangents, 16 * i + 4), mesh.tangents[i].direction.y);
    EXPECT_EQ(value_at<float>(tangents, 16 * i + 12), mesh.tangents[i].sign);
  }
}

TEST(WriteGlb, the_node_turns_z_up_into_y_up_exactly) {
  const Json matrix = testing::parts_of(glb(mesh_of(3))).json["nodes"][0]["matrix"];
  EXPECT_EQ(matrix, (Json{1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1}));
}

TEST(WriteGlb, views_name_their_targets) {
  const GltfParts parts = testing::parts_of(glb(mesh_of(3)));
  const Json& primitive = parts.json["meshes"][0]["primitives"][0];
  const auto target = [&](const Json& accessor) {
    const Json& view = parts.json["accessors"][accessor.get<std::size_t>()]["bufferView"];
    return parts.json["bufferViews"][view.get<std::size_t>()]["target"].get<int>();
  };
  for (const Json& accessor : primitive["attributes"]) EXPECT_EQ(target(accessor), 34962);
  EXPECT_EQ(target(primitive["indices"]), 34963);
}

TEST(WriteGlb, the_same_mesh_gives_the_same_bytes) {
  EXPECT_EQ(glb(small_mesh()), glb(small_mesh()));
}

TEST(WriteGlb, a_mesh_that_glTF_cannot_hold_is_refused) {
  EXPECT_THAT(error_of([] { glb({}); }), HasSubstr("no triangles"));
  TriangleMesh mesh = mesh_of(3);
  mesh.positions[1].y = 1e39;
  EXPECT_THAT(error_of([&] { glb(mesh); }), HasSubstr("reaches [2, 1e+39, 1], beyond the float32"));
}

TEST(WriteGltf, the_buffer_file_is_the_binary_chunk_of_the_glb_file) {
  const TriangleMesh mesh = small_mesh();
  std::ostringstream json, binary;
  write_gltf(json, binary, mesh, "my knot.bin");
  const GltfParts parts = testing::parts_of(glb(mesh));
  EXPECT_EQ(binary.str(), parts.binary);
  Json expected = parts.json;
  expected["buffers"][0]["uri"] = "my%20knot.bin";
  EXPECT_EQ(Json::parse(json.str()), expected);
}

}  // namespace
}  // namespace lumaknot::gltf
