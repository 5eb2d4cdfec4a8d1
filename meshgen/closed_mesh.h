/// The knot as a closed OpenMesh surface.
#pragma once

#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "scene/spec.h"

namespace lumaknot {

struct ClosedMeshTraits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = OpenMesh::Vec2d;  // float32 otherwise
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::TexCoord2D);
};

/// A triangle surface with unit vertex normals, and texture coordinates on the halfedge that
/// points to the corner, so that a seam needs no second vertex.
using ClosedMesh = OpenMesh::TriMesh_ArrayKernelT<ClosedMeshTraits>;

/// `mesh`, which knot_mesh() built from `knot`, with its seams sewn: segments x sides vertices per
/// component, closed and manifold, wound as `mesh` is. About 350 bytes per vertex.
ClosedMesh closed_mesh(const KnotSpec& knot, const TriangleMesh& mesh);

}  // namespace lumaknot
