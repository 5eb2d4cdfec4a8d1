#include "exporters/gltf/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "exporters/mesh/file.h"
#include "exporters/mesh/readers.h"
#include "system/atomic_file.h"
#include "system/error.h"

namespace lumaknot {
namespace {

/// The polygons of the file at `path`, which errors call `label` plus its path.
using Read = Polygons (*)(const std::filesystem::path& path, std::string_view label);

std::string name_of(const std::filesystem::path& path, std::string_view label) {
  return fmt::format("{} {}", label, path.string());
}

/// Reads a file that contains all of its mesh.
template <Polygons (*read)(std::string_view bytes, std::string_view name)>
Polygons read_whole(const std::filesystem::path& path, std::string_view label) {
  const std::string bytes = read_file(path, label), name = name_of(path, label);
  if (bytes.empty()) throw Error(fmt::format("{} is empty; export the mesh again", name));
  return read(bytes, name);
}

Polygons read_with_buffers(const std::filesystem::path& path, std::string_view label) {
  return read_gltf(path, name_of(path, label));
}

struct MeshFormat {
  std::string_view extension;
  Read read;
};

constexpr MeshFormat kFormats[] = {
    {".obj", read_whole<read_obj>}, {".ply", read_whole<read_ply>}, {".stl", read_whole<read_stl>},
    {".off", read_whole<read_off>}, {".om", read_whole<read_om>},   {".pov", read_whole<read_pov>},
    {".inc", read_whole<read_pov>}, {".glb", read_with_buffers},    {".gltf", read_with_buffers},
};

const MeshFormat& format_of(const std::filesystem::path& path, std::string_view name) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return char(std::tolower(c)); });
  const auto found = std::ranges::find(kFormats, extension, &MeshFormat::extension);
  if (found != std::end(kFormats)) return *found;
  std::string known;
  for (const MeshFormat& format : kFormats) known += fmt::format(" {}", format.extension);
  throw Error(fmt::format("{} must end in one of{}", name, known));
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path, bool needs_uvs, std::string_view label) {
  const std::string name = name_of(path, label);
  return triangulated(format_of(path, name).read(path, label), needs_uvs, name);
}

}  // namespace lumaknot
