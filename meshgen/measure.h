/// What is true of a mesh, whatever made it.
#pragma once

#include "meshgen/knot_mesh.h"

namespace lumaknot {

/// Vertices - edges + faces.
long long euler_characteristic(const ClosedMesh& mesh);

/// Handles of a closed connected surface: (2 - Euler characteristic) / 2.
long long genus(const ClosedMesh& mesh);

/// Edges with one face only; none in a closed surface.
std::size_t boundary_edges(const ClosedMesh& mesh);

/// Signed volume, positive for an outward surface, by the divergence theorem (cubic scene units).
double volume(const ClosedMesh& mesh);

}  // namespace lumaknot
