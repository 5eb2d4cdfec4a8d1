/// OpenMesh's own format, OM.
#pragma once

#include "exporters/mesh/format.h"

namespace lumaknot::om {

/// Versions 2.0 to 2.2.
Polygons read(std::string_view bytes, std::string_view name);

/// Through OpenMesh, which copies the mesh: positions and normals in double, texture coordinates in
/// float32. (OpenMesh 9 itself reads the positions as float32.) Throws Error if the mesh is not
/// manifold.
void write(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

}  // namespace lumaknot::om
