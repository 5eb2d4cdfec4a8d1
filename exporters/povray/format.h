/// POV-Ray's mesh2.
#pragma once

#include "exporters/mesh/format.h"

namespace lumaknot::povray {

/// The mesh2 objects of a POV-Ray scene, given in plain numbers. Textures are skipped.
Polygons read_pov(std::string_view bytes, std::string_view name);

/// `#declare lumaknot_mesh = mesh2 { ... }`.
void write_pov_include(std::ostream& stream, const TriangleMesh& mesh,
                       const MeshFileOptions& options);

/// The data of a mesh2: vertices, normals, texture coordinates, triangles.
void write_pov_mesh(std::ostream& stream, const TriangleMesh& mesh);

}  // namespace lumaknot::povray
