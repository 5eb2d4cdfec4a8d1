/// OpenMesh's OM files checked before OpenMesh reads them, since it believes what they say.
#pragma once

#include <string>
#include <string_view>

namespace lumaknot {

/// What of an OM file the mesh needs, in an OM file that OpenMesh can read without danger.
struct OmFile {
  std::string bytes;
  bool has_normals = false;     ///< a vertex
  bool has_uvs = false;         ///< a vertex
  bool has_corner_uvs = false;  ///< a halfedge
};

/// The chunks of `bytes` with positions, normals, texture coordinates and topology. Throws Error
/// with the byte where one is cut short, missing, of another form than OpenMesh 7 to 9 write, or
/// joins halfedges, vertices or faces that are not there.
OmFile checked_om(std::string_view bytes, std::string_view name);

}  // namespace lumaknot
