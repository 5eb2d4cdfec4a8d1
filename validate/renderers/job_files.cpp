#include "validate/renderers/job_files.h"

#include <cstring>
#include <vector>

#include "system/atomic_file.h"

namespace lumaknot::validate {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kPlace = "the job's folder";

}  // namespace

std::string float_bytes(std::span<const float> values) {
  std::string bytes(values.size_bytes(), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

Json write_job_mesh(const fs::path& folder, const TriangleMesh& mesh) {
  std::vector<float> vertices;
  vertices.reserve(mesh.positions.size() * 8);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d &p = mesh.positions[i], &n = mesh.normals[i];
    for (const double v : {p.x, p.y, p.z, n.x, n.y, n.z, mesh.uvs[i].u, mesh.uvs[i].v}) {
      vertices.push_back(float(v));
    }
  }
  std::string indices(mesh.triangles.size() * sizeof(Triangle), '\0');
  std::memcpy(indices.data(), mesh.triangles.data(), indices.size());
  write_file(folder / "mesh.bin", float_bytes(vertices), kPlace);
  write_file(folder / "indices.bin", indices, kPlace);
  return {{"vertices", "mesh.bin"},
          {"count", mesh.positions.size()},
          {"indices", "indices.bin"},
          {"triangles", mesh.triangles.size()}};
}

Json write_job_texture(const fs::path& folder, const std::string& name,
                       const TextureImage& texture) {
  std::vector<float> values;
  values.reserve(texture.pixels.size() * 4);
  for (int y = texture.height - 1; y >= 0; --y) {
    for (int x = 0; x < texture.width; ++x) {
      const Rgb& p = texture.at(x, y);
      for (const float v : {p.r, p.g, p.b, 1.0f}) values.push_back(v);
    }
  }
  write_file(folder / (name + ".bin"), float_bytes(values), kPlace);
  return {{"file", name + ".bin"}, {"width", texture.width}, {"height", texture.height}};
}

}  // namespace lumaknot::validate
