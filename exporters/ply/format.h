/// Stanford PLY.
#pragma once

#include "exporters/mesh/format.h"

namespace lumaknot::ply {

/// As text or binary of either byte order. Texture coordinates are the vertices' s, t; u, v or
/// texture_u, texture_v, or the faces' list texcoord.
Polygons read(std::string_view bytes, std::string_view name);

/// x y z nx ny nz s t, little-endian or text.
void write(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

}  // namespace lumaknot::ply
