/// OpenMesh's OM files, checked before OpenMesh reads them, since it trusts their contents.
#pragma once

#include <string>
#include <string_view>

namespace lumaknot::om {

/// The parts of an OM file that the mesh needs, as an OM file that OpenMesh can read safely.
struct OmFile {
  std::string bytes;
  bool has_normals = false;     ///< per vertex
  bool has_uvs = false;         ///< per vertex
  bool has_corner_uvs = false;  ///< per halfedge
};

/// The chunks of `bytes` with positions, normals, texture coordinates and topology. Throws Error
/// with the byte where one is cut short, missing, of another form than OpenMesh 7 to 9 write, or
/// refers to missing halfedges, vertices or faces.
OmFile checked_om(std::string_view bytes, std::string_view name);

}  // namespace lumaknot::om
