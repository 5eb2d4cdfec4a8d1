#include "meshgen/measure.h"

#include <algorithm>

namespace lumaknot {

long long euler_characteristic(const ClosedMesh& mesh) {
  return (long long)mesh.n_vertices() - (long long)mesh.n_edges() + (long long)mesh.n_faces();
}

long long genus(const ClosedMesh& mesh) { return (2 - euler_characteristic(mesh)) / 2; }

std::size_t boundary_edges(const ClosedMesh& mesh) {
  const auto edges = mesh.edges();
  return std::size_t(
      std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.is_boundary(); }));
}

double volume(const ClosedMesh& mesh) {
  double sum = 0;
  for (const auto face : mesh.faces()) {
    auto corner = mesh.cfv_ccwbegin(face);
    const auto a = mesh.point(*corner++), b = mesh.point(*corner++), c = mesh.point(*corner);
    sum += (a | (b % c)) / 6;
  }
  return sum;
}

}  // namespace lumaknot
