#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "exporters/mesh/format.h"
#include "system/error.h"

namespace lumaknot {
namespace {

const MeshFormat& readable_format(const std::filesystem::path& path, std::string_view name) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return char(std::tolower(c)); });
  if (const auto* format = find_mesh_format(extension, &MeshFormat::read)) return *format;
  throw Error(fmt::format("{} must end in one of {}", name,
                          fmt::join(mesh_endings(&MeshFormat::read), " ")));
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path, bool needs_uvs, std::string_view label) {
  const std::string name = mesh_file_name(path, label);
  return triangulated(readable_format(path, name).read(path, label), needs_uvs, name);
}

}  // namespace lumaknot
