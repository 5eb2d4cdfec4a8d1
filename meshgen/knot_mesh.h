/// The knot as a closed surface.
#pragma once

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "scene/scene.h"

namespace lumaknot {

struct ClosedMeshTraits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = OpenMesh::Vec2d;  // float32 else
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::TexCoord2D);
};

/// A triangle surface with unit vertex normals, and texture coordinates on the halfedge that
/// points to the corner, so that a seam needs no second vertex.
using ClosedMesh = OpenMesh::TriMesh_ArrayKernelT<ClosedMeshTraits>;

/// The tube along `knot`: segments x sides vertices, twice as many triangles, closed, manifold,
/// wound counter-clockwise seen from outside. Positions and normals are the exact tube's at the
/// vertices; u runs 0 ... repeat_u along the knot, v 0 ... repeat_v around the tube. Throws Error
/// when the lengths leave what double precision can hold.
ClosedMesh knot_mesh(const KnotSpec& knot);

/// `mesh` with one vertex for each pair of position and texture coordinate, in the order of first
/// use. A segments x sides knot gives (segments + 1) x (sides + 1) vertices.
TriangleMesh flat_mesh(const ClosedMesh& mesh);

}  // namespace lumaknot
