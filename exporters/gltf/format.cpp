#include "exporters/mesh/format.h"

#include <sstream>

#include "exporters/gltf/read.h"
#include "exporters/gltf/scene.h"

namespace lumaknot {
namespace {

Polygons read_with_buffers(const std::filesystem::path& path, std::string_view label) {
  return gltf::read_gltf(path, mesh_file_name(path, label));
}

/// NAME.bin first: the file that refers to it is the one to open.
void write_gltf_pair(const std::filesystem::path& path, const TriangleMesh& mesh,
                     std::string_view flag) {
  check_package_name(path, flag);
  std::filesystem::path binary = path;
  binary.replace_extension(".bin");
  std::ostringstream json;
  write_file(
      binary,
      [&](std::ostream& stream) {
        gltf::write_gltf(json, stream, mesh, binary.filename().string());
      },
      flag);
  write_file(path, json.str(), flag);
}

void write_gltf_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                     const MeshFileOptions&, std::string_view flag) {
  if (path.extension() == ".gltf") return write_gltf_pair(path, mesh, flag);
  write_file(path, [&](std::ostream& stream) { gltf::write_glb(stream, mesh); }, flag);
}

}  // namespace

extern const MeshFormat kGltfFormat{.endings = {".glb", ".gltf"},
                                    .read = read_with_buffers,
                                    .write = write_gltf_mesh,
                                    .has_binary = true,
                                    .has_tangents = true};

}  // namespace lumaknot
