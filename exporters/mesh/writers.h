/// One writer per mesh format. Each writes the numbers of `mesh` in float32, text in the fewest
/// digits that read back exactly, and leaves `stream` bad on failure. Except for OM, the memory
/// beyond the mesh is constant unless stated.
#pragma once

#include <ostream>

#include "exporters/mesh/file.h"

namespace lumaknot {

/// Wavefront OBJ: v, vt, vn, f with separate indices, each position once, so that readers see a
/// closed surface. Uses 10 more bytes per vertex.
void write_obj(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

/// PLY: x y z nx ny nz s t, little-endian or text.
void write_ply(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

/// STL, little-endian or text, with the facets' own normals; zero where a facet has no area.
void write_stl(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

/// OFF without normals and texture coordinates, which every reader accepts. Each position once, as
/// in write_obj().
void write_off(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

/// OpenMesh's own format, through OpenMesh, which copies the mesh: positions and normals in double,
/// texture coordinates in float32. (OpenMesh 9 itself reads the positions as float32.) Throws Error
/// if the mesh is not manifold.
void write_om(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

/// `#declare lumaknot_mesh = mesh2 { ... }` for POV-Ray.
void write_pov_include(std::ostream& stream, const TriangleMesh& mesh,
                       const MeshFileOptions& options);

/// The data of a mesh2: vertices, normals, texture coordinates, triangles.
void write_pov_mesh(std::ostream& stream, const TriangleMesh& mesh);

}  // namespace lumaknot
