#include "exporters/gltf/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "system/error.h"

namespace lumaknot::gltf {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

// Numbers of the specification, sections 5.1 and 5.11.
constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963, kNoTarget = 0;

/// 16 bits name vertices 0 to 65534; 65535 would restart the primitive.
constexpr std::size_t kMaxShortIndices = 65535;

constexpr std::uint64_t padded(std::uint64_t size) { return (size + 3) / 4 * 4; }

bool has_short_indices(const TriangleMesh& mesh) {
  return mesh.positions.size() <= kMaxShortIndices;
}

using Row3 = std::array<float, 3>;

Row3 to_row(const Vec3d& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// The smallest and largest coordinates. Rounding to float32 preserves order, so these are also
/// those of the file.
struct Bounds {
  Vec3d min, greatest;
};

Bounds bounds_of(const Bulk<Vec3d>& positions) {
  Bounds bounds{positions[0], positions[0]};
  for (const Vec3d& p : positions) {
    bounds.min = {std::min(bounds.min.x, p.x), std::min(bounds.min.y, p.y),
                  std::min(bounds.min.z, p.z)};
    bounds.greatest = {std::max(bounds.greatest.x, p.x), std::max(bounds.greatest.y, p.y),
                       std::max(bounds.greatest.z, p.z)};
  }
  return bounds;
}

Row3 checked_row(const Vec3d& bound) {
  const Row3 row = to_row(bound);
  if (std::ranges::all_of(row, [](float c) { return std::isfinite(c); })) return row;
  throw Error(
      fmt::format("the mesh reaches [{}, {}, {}], beyond the float32 that glTF holds; make "
                  "it smaller",
                  bound.x, bound.y, bound.z));
}

/// Writes row(0), row(1), ... of `rows` rows, about a thousand at a time.
template <class F>
void write_rows(std::ostream& stream, std::size_t rows, F row) {
  constexpr std::size_t kRowsAtOnce = 4096;
  std::vector<decltype(row(0))> chunk(std::min(rows, kRowsAtOnce));
  for (std::size_t first = 0; first < rows; first += kRowsAtOnce) {
    const std::size_t count = std::min(rows - first, kRowsAtOnce);
    for (std::size_t i = 0; i < count; ++i) chunk[i] = row(first + i);
    stream.write(reinterpret_cast<const char*>(chunk.data()),
                 std::streamsize(count * sizeof(chunk[0])));
  }
}

void write_padding(std::ostream& stream, std::uint64_t size, char value) {
  for (std::uint64_t i = size; i < padded(size); ++i) stream.put(value);
}

template <class Index>
void write_indices(std::ostream& stream, const Bulk<Triangle>& triangles) {
  write_rows(stream, triangles.size(), [&](std::size_t i) {
    const Triangle& t = triangles[i];
    return std::array<Index, 3>{Index(t[0]), Index(t[1]), Index(t[2])};
  });
  write_padding(stream, 3 * sizeof(Index) * triangles.size(), '\0');
}

void write_word(std::ostream& stream, std::uint64_t value) {
  const auto bytes = std::bit_cast<std::array<char, 4>>(std::uint32_t(value));
  stream.write(bytes.data(), 4);
}

}  // namespace

std::string gltf_uri(std::string_view name) {
  std::string uri;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '.' || c == '_' || c == '~';
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

Vec3d to_gltf(const Vec3d& v) { return {v.x, v.z, 0.0 - v.y}; }  // 0 - y: never -0

Json gltf_matrix(const CameraFrame& axes, const Vec3d& position) {
  Json matrix = Json::array();
  const auto add_column = [&](const Vec3d& v, double last) {
    for (const double c : components(to_gltf(v))) matrix.push_back(c);
    matrix.push_back(last);
  };
  for (const Vec3d& axis : {axes.right, axes.up, axes.back}) add_column(axis, 0);
  add_column(position, 1);
  return matrix;
}

GltfDocument::GltfDocument(const TriangleMesh& mesh)
    : json{{"asset", {{"version", "2.0"}, {"generator", "lumaknot"}}},
           {"scene", 0},
           {"scenes", {{{"nodes", {0}}}}},
           {"nodes", Json::array()}} {
  if (mesh.triangles.empty()) throw Error("the mesh has no triangles, which glTF can't hold");
  constexpr CameraFrame kOurAxes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  add("nodes", {{"name", "mesh"}, {"mesh", 0}, {"matrix", gltf_matrix(kOurAxes, {})}});
  const Bounds bounds = bounds_of(mesh.positions);
  const std::size_t vertices = mesh.positions.size();
  const std::size_t positions = add_array(vertices, kFloat, "VEC3", 12, kArrayBuffer);
  json["accessors"][positions]["min"] = checked_row(bounds.min);
  json["accessors"][positions]["max"] = checked_row(bounds.greatest);
  Json attributes{{"POSITION", positions}};
  attributes["NORMAL"] = add_array(vertices, kFloat, "VEC3", 12, kArrayBuffer);
  attributes["TEXCOORD_0"] = add_array(vertices, kFloat, "VEC2", 8, kArrayBuffer);
  if (!mesh.tangents.empty()) {
    attributes["TANGENT"] = add_array(vertices, kFloat, "VEC4", 16, kArrayBuffer);
  }
  const bool is_short = has_short_indices(mesh);
  const std::size_t indices =
      add_array(3 * mesh.triangles.size(), is_short ? kUnsignedShort : kUnsignedInt, "SCALAR",
                is_short ? 2 : 4, kElementArrayBuffer);
  Json primitive{{"attributes", attributes}, {"indices", indices}};
  add("meshes", {{"primitives", Json::array({primitive})}});
}

std::size_t GltfDocument::add(const char* key, Json value) {
  json[key].push_back(std::move(value));
  return json[key].size() - 1;
}

std::size_t GltfDocument::add_view(std::uint64_t size) {
  const std::size_t index =
      add("bufferViews", {{"buffer", 0}, {"byteOffset", buffer_size_}, {"byteLength", size}});
  buffer_size_ += padded(size);
  return index;
}

std::size_t GltfDocument::add_array(std::size_t count, int component, const char* type,
                                    std::size_t size, int target) {
  const std::size_t view = add_view(std::uint64_t(count) * size);
  if (target != kNoTarget) json["bufferViews"][view]["target"] = target;
  return add(
      "accessors",
      {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
}

std::string GltfDocument::text(std::string_view buffer_file) const {
  Json whole = json;
  Json buffer{{"byteLength", buffer_size_}};
  if (!buffer_file.empty()) buffer["uri"] = gltf_uri(buffer_file);
  whole["buffers"] = Json::array({buffer});
  return whole.dump(buffer_file.empty() ? -1 : 1);
}

void write_arrays(std::ostream& stream, const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  write_rows(stream, vertices, [&](std::size_t i) { return to_row(mesh.positions[i]); });
  write_rows(stream, vertices, [&](std::size_t i) { return to_row(mesh.normals[i]); });
  write_rows(stream, vertices, [&](std::size_t i) {
    return std::array<float, 2>{float(mesh.uvs[i].u), float(1 - mesh.uvs[i].v)};
  });
  write_rows(stream, mesh.tangents.size(), [&](std::size_t i) {
    const auto& [d, sign] = mesh.tangents[i];
    return std::array<float, 4>{float(d.x), float(d.y), float(d.z), float(sign)};
  });
  if (has_short_indices(mesh)) {
    write_indices<std::uint16_t>(stream, mesh.triangles);
  } else {
    write_indices<std::uint32_t>(stream, mesh.triangles);
  }
}

void write_container(std::ostream& stream, const GltfDocument& document, const TriangleMesh& mesh,
                     std::string_view tail) {
  const std::string text = document.text();
  const std::uint64_t size = 12 + 8 + padded(text.size()) + 8 + document.buffer_size();
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(
        fmt::format("a .glb file of {} bytes is more than its format holds; write .gltf", size));
  }
  stream << "glTF";
  write_word(stream, 2);
  write_word(stream, size);
  write_word(stream, padded(text.size()));
  stream << "JSON" << text;
  write_padding(stream, text.size(), ' ');
  write_word(stream, document.buffer_size());
  stream << std::string_view("BIN\0", 4);
  write_arrays(stream, mesh);
  stream << tail;
  write_padding(stream, tail.size(), '\0');
}

}  // namespace lumaknot::gltf
