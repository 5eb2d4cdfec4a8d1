#include "validate/gpu/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "validate/gpu/files.h"

namespace lumaknot::gpu {
namespace {

constexpr int kMaxVertices = 1 << 30;
constexpr int kMaxTriangles = 1 << 29;  // three indices each still count as int

}  // namespace

Mesh read_mesh(Fields fields, const std::filesystem::path& folder) {
  const auto count = std::uint64_t(fields.integer("count", 1, kMaxVertices));
  const auto triangles = std::uint64_t(fields.integer("triangles", 1, kMaxTriangles));
  Mesh mesh;
  mesh.vertices = read_array<float>(folder / fields.text("vertices"), fields.path("vertices"),
                                    count * kFloatsPerVertex);
  mesh.indices = read_array<std::uint32_t>(folder / fields.text("indices"), fields.path("indices"),
                                           triangles * 3);
  fields.finish();
  const auto wrong = std::ranges::find_if(mesh.indices, [&](auto i) { return i >= count; });
  if (wrong == mesh.indices.end()) return mesh;
  throw Error(fmt::format("{} must be below the mesh's {} vertices, but index {} is {}",
                          fields.path("indices"), count, wrong - mesh.indices.begin(), *wrong));
}

}  // namespace lumaknot::gpu
