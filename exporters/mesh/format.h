/// The table of mesh formats.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exporters/mesh/file.h"
#include "exporters/mesh/polygons.h"
#include "system/atomic_file.h"

namespace lumaknot {

/// All that is particular to a format that is read, written or both.
struct MeshFormat {
  std::array<std::string_view, 2> endings{};  ///< of its files, with their dots; the last may be ""
  std::string_view remark{};                  ///< on the endings, where the help lists them

  /// The polygons of the file at `path`. Throws Error, calling the file mesh_file_name(path, label)
  /// and giving the line or byte, for a file that is not of the format, is cut short, counts more
  /// than it can hold, has numbers that are not finite, or refers to missing vertices. Null: not
  /// read.
  Polygons (*read)(const std::filesystem::path& path, std::string_view label) = nullptr;

  /// Writes `mesh`, whose numbers fit in float32, with options that the format has: text in the
  /// fewest digits that read back exactly. Throws Error, naming `flag`. Null: not written.
  void (*write)(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshFileOptions& options, std::string_view flag) = nullptr;

  bool has_text = false;      ///< is written as text, always or as MeshFileOptions::ascii
  bool has_binary = false;    ///< is written as binary, always or unless MeshFileOptions::ascii
  bool has_quads = false;     ///< as MeshFileOptions::quads
  bool has_tangents = false;  ///< as MeshFileOptions::tangents
};

/// Selects formats: often a member, as &MeshFormat::has_quads or &MeshFormat::write.
using MeshFormatFilter = std::function<bool(const MeshFormat&)>;

/// All of them, in the order of messages.
std::span<const MeshFormat* const> mesh_formats();

/// The endings of the selected formats.
std::vector<std::string> mesh_endings(const MeshFormatFilter& is_selected);

/// The selected format whose files end in `ending`; null if there is none.
const MeshFormat* find_mesh_format(std::string_view ending, const MeshFormatFilter& is_selected);

/// What errors call the mesh file at `path`.
std::string mesh_file_name(const std::filesystem::path& path, std::string_view label);

/// The bytes of the mesh file at `path`. Throws Error when there are none.
std::string mesh_file_bytes(const std::filesystem::path& path, std::string_view label);

/// MeshFormat::read of a format whose files contain all of their mesh: `read` takes the bytes of
/// one, which errors call `name`.
template <Polygons (*read)(std::string_view bytes, std::string_view name)>
Polygons read_whole(const std::filesystem::path& path, std::string_view label) {
  return read(mesh_file_bytes(path, label), mesh_file_name(path, label));
}

/// MeshFormat::write of such a format: `write` leaves its stream bad on failure, and needs constant
/// memory beyond the mesh unless stated.
template <void (*write)(std::ostream&, const TriangleMesh&, const MeshFileOptions&)>
void write_whole(const std::filesystem::path& path, const TriangleMesh& mesh,
                 const MeshFileOptions& options, std::string_view flag) {
  write_file(path, [&](std::ostream& stream) { write(stream, mesh, options); }, flag);
}

}  // namespace lumaknot
