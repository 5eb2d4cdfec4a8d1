#include "exporters/mesh/format.h"

#include <fmt/format.h>

#include <algorithm>

#include "exporters/mesh/list.h"
#include "exporters/text/scanner.h"
#include "system/error.h"

namespace lumaknot {

#define LUMAKNOT_MESH_FORMAT(name) extern const MeshFormat k##name##Format;
LUMAKNOT_MESH_FORMATS(LUMAKNOT_MESH_FORMAT)
#undef LUMAKNOT_MESH_FORMAT

std::span<const MeshFormat* const> mesh_formats() {
#define LUMAKNOT_MESH_FORMAT(name) &k##name##Format,
  static constexpr auto kFormats =
      std::to_array<const MeshFormat*>({LUMAKNOT_MESH_FORMATS(LUMAKNOT_MESH_FORMAT)});
#undef LUMAKNOT_MESH_FORMAT
  return kFormats;
}

std::vector<std::string> mesh_endings(const MeshFormatFilter& is_selected) {
  std::vector<std::string> endings;
  for (const MeshFormat* format : mesh_formats()) {
    if (!is_selected(*format)) continue;
    for (const std::string_view ending : format->endings) {
      if (!ending.empty()) endings.emplace_back(ending);
    }
  }
  return endings;
}

const MeshFormat* find_mesh_format(std::string_view ending, const MeshFormatFilter& is_selected) {
  for (const MeshFormat* format : mesh_formats()) {
    const bool has_ending = !ending.empty() && std::ranges::count(format->endings, ending) > 0;
    if (has_ending && is_selected(*format)) return format;
  }
  return nullptr;
}

std::string mesh_file_name(const std::filesystem::path& path, std::string_view label) {
  return fmt::format("{} {}", label, path.string());
}

std::string mesh_file_bytes(const std::filesystem::path& path, std::string_view label) {
  std::string bytes = read_file(path, label);
  if (!bytes.empty()) return bytes;
  throw Error(fmt::format("{} is empty; {}", mesh_file_name(path, label), kExportAgain));
}

}  // namespace lumaknot
