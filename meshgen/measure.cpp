#include "meshgen/measure.h"

namespace lumaknot {
namespace {

constexpr int kUnseen = -1;

/// Labels every vertex connected to `seed` with `piece`.
void flood(const ClosedMesh& mesh, ClosedMesh::VertexHandle seed, int piece,
           std::vector<int>& piece_of) {
  std::vector<ClosedMesh::VertexHandle> waiting{seed};
  piece_of[std::size_t(seed.idx())] = piece;
  while (!waiting.empty()) {
    const auto vertex = waiting.back();
    waiting.pop_back();
    for (const auto next : mesh.vv_range(vertex)) {
      if (piece_of[std::size_t(next.idx())] != kUnseen) continue;
      piece_of[std::size_t(next.idx())] = piece;
      waiting.push_back(next);
    }
  }
}

struct Corners {
  ClosedMesh::Point a, b, c;
};

Corners corners_of(const ClosedMesh& mesh, ClosedMesh::FaceHandle face) {
  auto corner = mesh.cfv_ccwbegin(face);
  const auto a = mesh.point(*corner++), b = mesh.point(*corner++);
  return {a, b, mesh.point(*corner)};
}

}  // namespace

std::vector<ConnectedComponent> connected_components(const ClosedMesh& mesh) {
  std::vector<int> piece_of(mesh.n_vertices(), kUnseen);
  std::vector<ConnectedComponent> all;
  for (const auto vertex : mesh.vertices()) {
    if (piece_of[std::size_t(vertex.idx())] == kUnseen) {
      flood(mesh, vertex, int(all.size()), piece_of);
      all.emplace_back();
    }
    ++all[std::size_t(piece_of[std::size_t(vertex.idx())])].vertices;
  }
  const auto piece_at = [&](ClosedMesh::VertexHandle vertex) -> ConnectedComponent& {
    return all[std::size_t(piece_of[std::size_t(vertex.idx())])];
  };
  for (const auto edge : mesh.edges()) {
    ConnectedComponent& piece = piece_at(edge.v0());
    ++piece.edges;
    piece.boundary_edges += edge.is_boundary();
  }
  for (const auto face : mesh.faces()) ++piece_at(*mesh.cfv_ccwbegin(face)).faces;
  return all;
}

double volume(const ClosedMesh& mesh) {
  double sum = 0;
  for (const auto face : mesh.faces()) {
    const Corners t = corners_of(mesh, face);
    sum += (t.a | (t.b % t.c)) / 6;
  }
  return sum;
}

double area(const ClosedMesh& mesh) {
  double sum = 0;
  for (const auto face : mesh.faces()) {
    const Corners t = corners_of(mesh, face);
    sum += ((t.b - t.a) % (t.c - t.a)).norm() / 2;
  }
  return sum;
}

}  // namespace lumaknot
