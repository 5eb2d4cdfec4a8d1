/// Tangents for normal mapping.
#pragma once

#include "scene/triangle_mesh.h"

namespace lumaknot {

/// The tangent of each vertex of `mesh`, as defined by MikkTSpace (Mikkelsen: Simulation of
/// Wrinkled Surfaces Revisited, 2008): the triangles' directions of increasing u, each projected to
/// be normal to the vertex's normal, unit, weighted by the triangle's angle there. All triangles at
/// a vertex must be mapped with the same orientation, as a knot's are; the sign is the first one's.
/// A vertex without extent in the texture gets an arbitrary direction normal to its normal.
Bulk<Tangent> tangents(const TriangleMesh& mesh);

}  // namespace lumaknot
