#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "exporters/gltf/read.h"
#include "tests/exporters/gltf/testing.h"

namespace lumaknot::gltf {
namespace {

using ::testing::AllOf;
using testing::GltfParts;
using ::testing::HasSubstr;
using testing::Json;
using ::testing::Not;
using ::testing::StartsWith;
using testing::TemporaryFolder;
using testing::triangle_parts;

std::string error_of_bytes(std::string_view bytes) {
  return error_of([&] { testing::read_bytes(bytes); });
}

/// The error of the small file, changed by a JSON patch (RFC 6902).
std::string error_of_patch(const char* patch) {
  GltfParts parts = triangle_parts();
  parts.json = parts.json.patch(Json::parse(patch));
  return error_of_bytes(testing::glb_of(parts));
}

void expect_refused(const std::string& error, std::string_view place) {
  EXPECT_THAT(error,
              AllOf(StartsWith("mesh.file test.glb: "), HasSubstr(place), Not(HasSubstr("\n"))));
}

TEST(BadGltf, every_wrong_number_is_reported_by_its_json_path) {
  const std::pair<const char*, const char*> cases[] = {
      {R"([{"op": "remove", "path": "/asset"}])", "asset is missing"},
      {R"([{"op": "replace", "path": "/asset/version", "value": "1.0"}])", "asset.version"},
      {R"([{"op": "replace", "path": "/asset/version", "value": 2}])", "asset.version must be a"},
      {R"([{"op": "replace", "path": "/scene", "value": 5}])", "scene is 5"},
      {R"([{"op": "replace", "path": "/scene", "value": -1}])", "scene must be an integer"},
      {R"([{"op": "replace", "path": "/scenes/0/nodes/0", "value": 9}])", "scenes[0].nodes[0]"},
      {R"([{"op": "add", "path": "/scenes/0/nodes/0", "value": 0}])", "scenes[0].nodes[1]"},
      {R"([{"op": "replace", "path": "/nodes/0/mesh", "value": 3}])", "nodes[0].mesh is 3"},
      {R"([{"op": "replace", "path": "/nodes/0/mesh", "value": 4294967296}])", "nodes[0].mesh"},
      {R"([{"op": "add", "path": "/nodes/0/matrix", "value": [1, 2]}])", "nodes[0].matrix must"},
      {R"([{"op": "add", "path": "/nodes/0/matrix",
            "value": [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}])",
       "nodes[0].matrix must"},
      {R"([{"op": "add", "path": "/nodes/0/rotation", "value": [0, 0, 0, 0]}])",
       "nodes[0].rotation"},
      {R"([{"op": "add", "path": "/nodes/0/translation", "value": [0, 0, "0"]}])",
       "nodes[0].translation[2]"},
      {R"([{"op": "add", "path": "/nodes/0/scale", "value": [1e300, 1e300, 1e300]}])",
       "meshes[0].primitives[0].attributes.NORMAL"},
      {R"([{"op": "replace", "path": "/nodes/0", "value": 7}])", "nodes[0] must be an object"},
      {R"([{"op": "replace", "path": "/meshes/0/primitives/0/attributes/POSITION", "value": 4}])",
       "meshes[0].primitives[0].attributes.POSITION is 4"},
      {R"([{"op": "replace", "path": "/meshes/0/primitives/0/attributes/POSITION", "value": 2}])",
       "accessors[2] has a type that meshes[0].primitives[0].attributes.POSITION"},
      {R"([{"op": "remove", "path": "/meshes/0/primitives/0/attributes/POSITION"}])",
       "meshes[0].primitives[0].attributes.POSITION is missing"},
      {R"([{"op": "replace", "path": "/meshes/0/primitives/0/indices", "value": 17}])",
       "meshes[0].primitives[0].indices is 17"},
      {R"([{"op": "add", "path": "/meshes/0/primitives/0/mode", "value": 7}])",
       "meshes[0].primitives[0].mode"},
      {R"([{"op": "add", "path": "/meshes/0/primitives/0/mode", "value": 1}])", "no triangles"},
      {R"([{"op": "replace", "path": "/meshes/0/primitives", "value": {}}])",
       "meshes[0].primitives must be a list"},
      {R"([{"op": "replace", "path": "/accessors/0/count", "value": 4}])", "accessors[0] has 4"},
      {R"([{"op": "replace", "path": "/accessors/0/count", "value": 1099511627776}])",
       "accessors[0] has 1099511627776"},
      {R"([{"op": "replace", "path": "/accessors/0/count", "value": 18446744073709551615}])",
       "accessors[0].count must be"},
      {R"([{"op": "replace", "path": "/accessors/0/count", "value": 0}])", "accessors[0] has 0"},
      {R"([{"op": "replace", "path": "/accessors/0/count", "value": 2.5}])", "accessors[0].count"},
      {R"([{"op": "replace", "path": "/accessors/1/count", "value": 2}])",
       "meshes[0].primitives[0].attributes has 3 and 2 elements"},
      {R"([{"op": "replace", "path": "/accessors/3/count", "value": 2}])",
       "meshes[0].primitives[0] has 2 corners"},
      {R"([{"op": "replace", "path": "/accessors/3/componentType", "value": 5122}])",
       "meshes[0].primitives[0].indices must be unsigned"},
      {R"([{"op": "replace", "path": "/accessors/3/componentType", "value": 5124}])",
       "accessors[3].componentType"},
      {R"([{"op": "replace", "path": "/accessors/0/type", "value": "VEC9"}])", "accessors[0].type"},
      {R"([{"op": "add", "path": "/accessors/0/byteOffset", "value": 4}])", "accessors[0] has 3"},
      {R"([{"op": "add", "path": "/accessors/0/byteOffset", "value": "4"}])",
       "accessors[0].byteOffset must be"},
      {R"([{"op": "add", "path": "/accessors/0/sparse", "value": {}}])",
       "accessors[0].sparse is not read"},
      {R"([{"op": "remove", "path": "/accessors/0/bufferView"}])", "accessors[0].bufferView"},
      {R"([{"op": "remove", "path": "/accessors/3/bufferView"}])", "accessors[3].bufferView"},
      {R"([{"op": "replace", "path": "/accessors/0/bufferView", "value": 8}])",
       "accessors[0].bufferView is 8"},
      {R"([{"op": "replace", "path": "/bufferViews/0/buffer", "value": 1}])",
       "bufferViews[0].buffer is 1"},
      {R"([{"op": "replace", "path": "/bufferViews/0/byteOffset", "value": 67}])",
       "bufferViews[0] ends at byte 103"},
      {R"([{"op": "replace", "path": "/bufferViews/0/byteOffset", "value": 1099511627776}])",
       "bufferViews[0] ends at byte 1099511627812"},
      {R"([{"op": "add", "path": "/bufferViews/0/byteStride", "value": 3}])",
       "bufferViews[0].byteStride must be a multiple"},
      {R"([{"op": "add", "path": "/bufferViews/0/byteStride", "value": 8}])",
       "bufferViews[0].byteStride is 8"},
      {R"([{"op": "replace", "path": "/buffers/0/byteLength", "value": 200}])",
       "buffers[0] has 104 bytes"},
      {R"([{"op": "add", "path": "/buffers/1", "value": {"byteLength": 1}}])", "buffers[1].uri"},
      {R"([{"op": "add", "path": "/buffers/1",
            "value": {"byteLength": 9, "uri": "data:application/octet-stream;base64,AAAA"}}])",
       "buffers[1] has 3 bytes"},
      {R"([{"op": "add", "path": "/buffers/1", "value": {"byteLength": 9, "uri": "data:x"}}])",
       "buffers[1].uri is not a buffer in base64"},
      {R"([{"op": "add", "path": "/extensionsRequired",
            "value": ["KHR_draco_mesh_compression"]}])",
       "\"KHR_draco_mesh_compression\""},
      {R"([{"op": "add", "path": "/extensionsRequired", "value": ["KHR_materials_ior",
            "EXT_meshopt_compression"]}])",
       "extensionsRequired[1] is \"EXT_meshopt_compression\""},
      {R"([{"op": "replace", "path": "/nodes", "value": []}])", "scenes[0].nodes[0] is 0"},
      {R"([{"op": "remove", "path": "/meshes"}])", "nodes[0].mesh is 0"},
      {R"([{"op": "add", "path": "/nodes/0/children", "value": [0]}])", "scenes[0].nodes[0]"},
      {R"([{"op": "add", "path": "/nodes/1", "value": {"children": [2]}},
           {"op": "add", "path": "/nodes/2", "value": {"children": [1, 0, 0]}}])",
       "nodes[2].children[2] is 0"},
      {R"([{"op": "add", "path": "/nodes/1", "value": {"mesh": 3}}])", "nodes[1].mesh is 3"},
      {R"([{"op": "add", "path": "/nodes/0/scale", "value": [1, 2, 3, 4]}])",
       "nodes[0].scale must be 3 numbers"},
      {R"([{"op": "add", "path": "/accessors/0/sparse", "value": null}])",
       "accessors[0].sparse is not read"},
      {R"([{"op": "replace", "path": "/accessors/2/componentType", "value": "x"}])",
       "accessors[2].componentType must be 5120 to 5123, 5125 or 5126, got \"x\""},
      {R"([{"op": "add", "path": "/buffers/1",
            "value": {"byteLength": 1, "uri": "data:application/octet-stream;base64,AA*A"}}])",
       "buffers[1].uri is not a buffer in base64"},
      {R"([{"op": "add", "path": "/buffers/1", "value": {"byteLength": 1, "uri": "data:,AAAA"}}])",
       "buffers[1].uri is not a buffer in base64"},
  };
  for (const auto& [patch, place] : cases) expect_refused(error_of_patch(patch), place);
}

TEST(BadGltf, one_wrong_node_of_many_is_reported) {
  constexpr std::size_t kNodes = 100'000;
  const std::pair<Json, const char*> cases[] = {
      {{{"mesh", 9}}, "nodes[99999].mesh is 9, but there are 1 meshes"},
      {{{"mesh", "x"}}, "nodes[99999].mesh must be an integer"},
      {{{"children", {kNodes}}}, "nodes[99999].children[0] is 100000, but there are 100000 nodes"}};
  for (const auto& [node, problem] : cases) {
    GltfParts parts = triangle_parts();
    parts.json["nodes"] = Json(kNodes, {{"mesh", 0}});
    parts.json["nodes"].back() = node;
    expect_refused(error_of_bytes(testing::glb_of(parts)), problem);
  }
}

TEST(BadGltf, a_cycle_that_no_scene_names_is_not_walked) {
  GltfParts parts = triangle_parts();
  parts.json["nodes"].push_back({{"children", {2}}, {"mesh", 0}});
  parts.json["nodes"].push_back({{"children", {1}}, {"mesh", 0}});
  EXPECT_EQ(testing::read_parts(parts).sizes.size(), 1u);
  parts.json.erase("scene");
  parts.json.erase("scenes");
  EXPECT_EQ(testing::read_parts(parts).sizes.size(), 1u);
}

TEST(BadGltf, a_tree_of_any_depth_is_walked) {
  GltfParts parts = triangle_parts();
  constexpr int kDepth = 100'000;  // a recursion would need more than a stack
  parts.json["nodes"] = Json::array();
  for (int i = 1; i < kDepth; ++i) parts.json["nodes"].push_back({{"children", {i}}});
  parts.json["nodes"].push_back({{"mesh", 0}});
  EXPECT_EQ(testing::read_parts(parts).sizes.size(), 1u);
}

TEST(BadGltf, instances_that_would_fill_the_memory_are_refused_first) {
  GltfParts parts = triangle_parts();
  constexpr std::size_t kVertices = 300'000, kNodes = 100;
  const std::size_t positions =
      testing::add_accessor(parts, std::string(12 * kVertices, '\0'), 5126, kVertices, "VEC3");
  parts.json["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", positions}}}};
  parts.json["nodes"] = Json(kNodes, {{"mesh", 0}});
  parts.json["scenes"][0].erase("nodes");
  for (std::size_t i = 0; i < kNodes; ++i) parts.json["scenes"][0]["nodes"].push_back(i);
  expect_refused(error_of_bytes(testing::glb_of(parts)), "nodes[66] brings the scene to 20100000");
}

TEST(BadGltf, numbers_that_are_not_finite_are_refused) {
  constexpr std::pair<std::size_t, const char*> kPlaces[] = {
      {4, "POSITION"}, {36 + 16, "NORMAL"}, {72 + 20, "TEXCOORD_0"}};
  for (const auto& [at, attribute] : kPlaces) {
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
      GltfParts parts = triangle_parts();
      parts.binary.replace(at, 4, testing::bytes_of<float>({value}));
      expect_refused(error_of_bytes(testing::glb_of(parts)),
                     std::string("meshes[0].primitives[0].attributes.") + attribute);
    }
  }
}

TEST(BadGltf, indices_beyond_the_vertices_are_refused) {
  GltfParts parts = triangle_parts();
  parts.binary.replace(98, 2, testing::bytes_of<std::uint16_t>({3}));
  expect_refused(error_of_bytes(testing::glb_of(parts)),
                 "meshes[0].primitives[0].indices refers to vertex 3 at 1");
}

TEST(BadGltf, wrong_files_are_reported_by_the_byte_or_path) {
  const std::string good = testing::glb_of(triangle_parts());
  const auto with = [&](std::size_t at, std::string_view bytes) {
    return std::string(good).replace(at, bytes.size(), bytes);
  };
  const std::pair<std::string, const char*> cases[] = {
      {"", "byte 1 of the text is not JSON"},
      {"glTF", "byte 4"},
      {"not a mesh", "byte 2 of the text is not JSON"},
      {"[]", "the document must be an object"},
      {R"({"asset": {"version": 1e999}})", "byte 27 of the text is not JSON"},
      {with(4, std::string("\1\0\0\0", 4)), "byte 4 has version 1"},
      {good + "more", "byte 8 states"},
      {good.substr(0, 100), "byte 8 states"},
      {with(12, "\xff\xff\xff\xff"), "byte 12 begins a chunk"},
      {with(16, "BSON"), "byte 16 must begin with a JSON chunk"},
      {R"({"asset": {"version": "2.0", "version": "2.1"}})", "asset.version appears twice"},
      {R"({"nodes": [{}, {"mesh": 0, "mesh": 1}]})", "nodes[1].mesh appears twice"}};
  for (const auto& [bytes, place] : cases) expect_refused(error_of_bytes(bytes), place);
}

TEST(BadGltf, buffers_outside_the_folder_are_not_read) {
  const TemporaryFolder outer;
  outer.file("secret.bin", triangle_parts().binary);
  const auto folder = outer / "inner";
  std::filesystem::create_directory(folder);
  std::filesystem::create_symlink(outer / "secret.bin", folder / "link.bin");
  const auto error_of_uri = [&](const std::string& uri) {
    Json json = triangle_parts().json;
    json["buffers"][0]["uri"] = uri;
    write_file(folder / "test.gltf", json.dump(), "--test");
    return error_of([&] { read_gltf(folder / "test.gltf", "mesh.file test.glb"); });
  };
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"),
        std::string("a/../../secret.bin"), (outer / "secret.bin").string(),
        "file://" + (outer / "secret.bin").string(), std::string("http://example.org/a.bin"),
        std::string("..\\secret.bin"), std::string("link.bin"), std::string("none.bin"),
        std::string("a%00b"), std::string("."), std::string("")}) {
    expect_refused(error_of_uri(uri), "buffers[0].uri");
  }
  std::filesystem::copy_file(outer / "secret.bin", folder / "own.bin");
  EXPECT_EQ(error_of_uri("own.bin"), "");
}

TEST(BadGltf, missing_files_are_refused_by_name) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of([&] { read_gltf(folder / "none.glb", "mesh.file"); }),
              HasSubstr("none.glb"));
}

/// Reads bytes that may be damaged: gives a mesh or an Error of one line, nothing else.
void expect_answer_or_error(const TemporaryFolder& folder, const std::string& bytes) {
  try {
    const Polygons polygons = testing::read_bytes(folder, bytes);
    for (const PolygonCorner& corner : polygons.corners) {
      ASSERT_LT(corner.position, polygons.positions.size());
    }
  } catch (const Error& error) {
    expect_refused(error.what(), "");
  }
}

TEST(BadGltf, every_shorter_file_is_refused) {
  const TemporaryFolder folder;
  const auto error_of_cut = [&](const std::string& bytes) {
    return error_of([&] { testing::read_bytes(folder, bytes); });
  };
  const std::string good = testing::glb_of(triangle_parts());
  for (std::size_t size = 0; size < good.size(); ++size) {
    std::string cut = good.substr(0, size);
    expect_refused(error_of_cut(cut), "");
    if (size < 12) continue;
    // With the shorter length in the header.
    cut.replace(8, 4, testing::bytes_of<std::uint32_t>({std::uint32_t(size)}));
    expect_refused(error_of_cut(cut), "");
  }
}

TEST(BadGltf, flipped_bytes_give_a_mesh_or_an_error) {
  const TemporaryFolder folder;
  const std::string good = testing::glb_of(triangle_parts());
  std::mt19937 random(1);
  for (int run = 0; run < 5000; ++run) {
    std::string bytes = good;
    for (unsigned flips = 1 + random() % 4; flips > 0; --flips) {
      bytes[random() % bytes.size()] = char(random());
    }
    expect_answer_or_error(folder, bytes);
  }
}

TEST(BadGltf, swapped_words_of_the_json_give_a_mesh_or_an_error) {
  const TemporaryFolder folder;
  const GltfParts good = triangle_parts();
  const char* const values[] = {"-1",    "0",    "1e9",       "1e999", "18446744073709551615",
                                "\"x\"", "null", "[]",        "{}",    "[[]]",
                                "true",  "3.5",  "2147483648"};
  std::mt19937 random(2);
  for (int run = 0; run < 3000; ++run) {
    std::string text = good.json.dump();
    const std::size_t number = text.find_first_of("0123456789", random() % text.size());
    if (number == text.npos) continue;
    const std::size_t end = text.find_first_not_of("0123456789.", number);
    text.replace(number, end - number, values[random() % std::size(values)]);
    const Json changed = Json::parse(text, nullptr, false);
    if (changed.is_discarded()) {
      expect_answer_or_error(folder, text);
    } else {
      expect_answer_or_error(folder, testing::glb_of({changed, good.binary}));
    }
  }
}

}  // namespace
}  // namespace lumaknot::gltf
