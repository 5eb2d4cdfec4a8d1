#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "exporters/mesh/format.h"
#include "system/error.h"
#include "system/listing.h"

namespace lumaknot {
namespace {

/// ".obj, .ply or .off": the endings of the formats that `is_selected` selects.
std::string endings(const MeshFormatFilter& is_selected) {
  return listing(mesh_endings(is_selected), "or");
}

const MeshFormat& writable_format(const std::filesystem::path& path, std::string_view flag) {
  const std::string extension = path.extension().string();
  if (const auto* format = find_mesh_format(extension, &MeshFormat::write)) return *format;
  throw Error(
      fmt::format("{} {} must end in {}", flag, path.string(), endings(&MeshFormat::write)));
}

bool fits(double value) { return std::abs(value) <= std::numeric_limits<float>::max(); }

/// Numbers beyond float32 would be written as infinite.
void check_fits(const TriangleMesh& mesh, std::string_view flag) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d& p = mesh.positions[i];
    const Vec2d& uv = mesh.uvs[i];
    if (fits(p.x) && fits(p.y) && fits(p.z) && fits(uv.u) && fits(uv.v)) continue;
    throw Error(
        fmt::format("{}: vertex {} of the mesh does not fit in float32: position ({}, {}, {}), "
                    "texture coordinate ({}, {}); make the mesh smaller",
                    flag, i, p.x, p.y, p.z, uv.u, uv.v));
  }
}

}  // namespace

void check_mesh_output(const std::filesystem::path& path, const MeshFileOptions& options,
                       std::string_view flag) {
  const MeshFormat& format = writable_format(path, flag);
  if (options.ascii && !format.has_text) {
    throw Error(fmt::format("{} {} can't be text: its format is binary only; end it in {}", flag,
                            path.string(), endings(&MeshFormat::has_text)));
  }
  if (options.quads && !format.has_quads) {
    throw Error(fmt::format("{} {} can't hold quads: its format has triangles only; end it in {}",
                            flag, path.string(), endings(&MeshFormat::has_quads)));
  }
  if (options.tangents && !format.has_tangents) {
    throw Error(fmt::format("{} {} can't hold tangents; end it in {}", flag, path.string(),
                            endings(&MeshFormat::has_tangents)));
  }
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshFileOptions& options, std::string_view flag) {
  check_mesh_output(path, options, flag);
  if (options.quads && !mesh.quads) {
    throw Error(
        fmt::format("{} {} can't hold quads: the mesh has triangles only; don't ask for quads",
                    flag, path.string()));
  }
  check_fits(mesh, flag);
  writable_format(path, flag).write(path, mesh, options, flag);
}

}  // namespace lumaknot
