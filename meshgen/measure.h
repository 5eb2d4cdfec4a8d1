/// Measurements of a mesh of any origin.
#pragma once

#include <vector>

#include "meshgen/closed_mesh.h"

namespace lumaknot {

/// The counts of one connected component of a surface.
struct ConnectedComponent {
  long long vertices = 0, edges = 0, faces = 0, boundary_edges = 0;

  long long euler_characteristic() const { return vertices - edges + faces; }
  /// Handles, when it is closed: (2 - Euler characteristic) / 2.
  long long genus() const { return (2 - euler_characteristic()) / 2; }
};

/// The connected components of `mesh`, in the order of their first vertices.
std::vector<ConnectedComponent> connected_components(const ClosedMesh& mesh);

/// Signed volume by the divergence theorem, positive for an outward surface, in cubic scene units.
double volume(const ClosedMesh& mesh);

/// Surface area, in square scene units.
double area(const ClosedMesh& mesh);

}  // namespace lumaknot
