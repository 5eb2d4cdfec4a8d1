/// Shared by the tests of glTF files: a small file to change, and files taken apart.
#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "exporters/gltf/read.h"
#include "tests/exporters/testing.h"

namespace lumaknot::testing {

using Json = nlohmann::ordered_json;

/// A glTF file in its two parts.
struct GltfParts {
  Json json;
  std::string binary;
};

template <class T>
T value_at(std::string_view bytes, std::size_t at) {
  T value{};
  if (at + sizeof(T) > bytes.size()) throw std::runtime_error("beyond the end");
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// The parts of a .glb file, according to the specification, section 4.4.
inline GltfParts parts_of(std::string_view glb) {
  const auto json_size = value_at<std::uint32_t>(glb, 12);
  const auto binary_size = value_at<std::uint32_t>(glb, 20 + json_size);
  return {Json::parse(glb.substr(20, json_size)),
          std::string(glb.substr(28 + json_size, binary_size))};
}

/// The bytes of a .glb file.
inline std::string glb_of(const GltfParts& parts) {
  std::string text = parts.json.dump(), binary = parts.binary;
  text.resize((text.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4);
  const auto word = [](std::size_t value) {
    return bytes_of<std::uint32_t>({std::uint32_t(value)});
  };
  return "glTF" + word(2) + word(28 + text.size() + binary.size()) + word(text.size()) + "JSON" +
         text + word(binary.size()) + std::string("BIN\0", 4) + binary;
}

/// One triangle in glTF's frame at (0,0,0), (1,0,0), (0,1,0), seen from +Z, with normals, texture
/// coordinates (0, 0.75), (1, 0.75), (0, 0.25) and 16-bit indices; on one node with no transform.
inline GltfParts triangle_parts() {
  GltfParts parts;
  parts.json = Json::parse(R"({
    "asset": {"version": "2.0"},
    "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [
      {"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3}]}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
      {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2"},
      {"bufferView": 3, "componentType": 5123, "count": 3, "type": "SCALAR"}],
    "bufferViews": [
      {"buffer": 0, "byteOffset": 0, "byteLength": 36},
      {"buffer": 0, "byteOffset": 36, "byteLength": 36},
      {"buffer": 0, "byteOffset": 72, "byteLength": 24},
      {"buffer": 0, "byteOffset": 96, "byteLength": 6}],
    "buffers": [{"byteLength": 102}]})");
  parts.binary =
      bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}) +
      bytes_of<float>({0, 0.75f, 1, 0.75f, 0, 0.25f}) + bytes_of<std::uint16_t>({0, 1, 2});
  return parts;
}

/// Adds an accessor of new bytes to the buffer and returns its index.
inline std::size_t add_accessor(GltfParts& parts, const std::string& bytes, int component,
                                std::size_t count, const char* type) {
  Json& json = parts.json;
  parts.binary.resize((parts.binary.size() + 3) / 4 * 4);
  json["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", parts.binary.size()}, {"byteLength", bytes.size()}});
  parts.binary += bytes;
  json["buffers"][0]["byteLength"] = parts.binary.size();
  json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                               {"componentType", component},
                               {"count", count},
                               {"type", type}});
  return json["accessors"].size() - 1;
}

/// The result of read_gltf() on the bytes in a file of `folder`, called "mesh.file test.glb". The
/// file is not written atomically, which would take a hundred times as long.
inline Polygons read_bytes(const TemporaryFolder& folder, std::string_view bytes) {
  std::filesystem::remove(folder / "test.glb");  // overwriting a file waits for the disk
  std::ofstream(folder / "test.glb", std::ios::binary) << bytes;
  return gltf::read_gltf(folder / "test.glb", "mesh.file test.glb");
}

inline Polygons read_bytes(std::string_view bytes) { return read_bytes(TemporaryFolder(), bytes); }

inline Polygons read_parts(const GltfParts& parts) { return read_bytes(glb_of(parts)); }

/// The positions of the corners, polygon after polygon.
inline std::vector<Vec3d> corner_positions(const Polygons& polygons) {
  std::vector<Vec3d> positions;
  for (const PolygonCorner& c : polygons.corners)
    positions.push_back(polygons.positions[c.position]);
  return positions;
}

}  // namespace lumaknot::testing
