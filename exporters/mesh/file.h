/// Triangle meshes in files of the formats in list.h.
#pragma once

#include <filesystem>

#include "scene/triangle_mesh.h"

namespace lumaknot {

/// How a mesh is written, where its format offers a choice.
struct MeshFileOptions {
  bool ascii = false;     ///< as text, also where the format is otherwise binary
  bool quads = false;     ///< pairs of triangles as quads, if the mesh has quads
  bool tangents = false;  ///< with the mesh's tangents
};

/// Writes `mesh` in float32, .om in double. Uses all cores and constant memory, except for .obj and
/// .off (10 bytes per vertex) and .om (a copy). The bytes do not depend on the number of cores. The
/// file is written whole or not at all; `flag` names it in an Error.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshFileOptions& options, std::string_view flag);

/// Throws Error, naming `flag`, unless write_mesh() knows the extension of `path` and its format
/// supports the `options`.
void check_mesh_output(const std::filesystem::path& path, const MeshFileOptions& options,
                       std::string_view flag);

/// The triangles of a mesh file. Numbers are read as double, so that float32 in its shortest digits
/// comes back unchanged. Polygons are triangulated, concave ones too; missing and zero normals
/// become smooth; one vertex is kept for each set of equal attributes. With `needs_uvs`, a mesh
/// without texture coordinates is refused; otherwise they are zero. Throws Error calling the file
/// `label`, with the line or byte, for a file that is cut short or not of its format, counts more
/// than it can hold, has numbers beyond float32 or indices beyond its arrays, or is not a surface:
/// an edge that more than two faces share or two use in the same direction.
TriangleMesh read_mesh(const std::filesystem::path& path, bool needs_uvs, std::string_view label);

}  // namespace lumaknot
