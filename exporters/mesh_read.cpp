#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "exporters/mesh_file.h"
#include "exporters/mesh_readers.h"
#include "scene/atomic_file.h"
#include "scene/error.h"

namespace lumaknot {
namespace {

struct MeshFormat {
  std::string_view extension;
  Polygons (*read)(std::string_view bytes, std::string_view name);
};

constexpr MeshFormat kFormats[] = {
    {".obj", read_obj}, {".ply", read_ply}, {".stl", read_stl}, {".off", read_off},
    {".om", read_om},   {".pov", read_pov}, {".inc", read_pov},
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
  const std::string name = fmt::format("{} {}", label, path.string());
  const MeshFormat& format = format_of(path, name);
  const std::string bytes = read_file(path, label);
  if (bytes.empty()) throw Error(fmt::format("{} is empty; export the mesh again", name));
  return triangulated(format.read(bytes, name), needs_uvs, name);
}

}  // namespace lumaknot
