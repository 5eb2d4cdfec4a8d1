// Builds a flat mesh and prints its size in bytes. The caller measures its peak memory.
//   lumaknot_bench_mesh SEGMENTS SIDES
#include <fmt/format.h>

#include <cstdlib>

#include "meshgen/knot_mesh.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: lumaknot_bench_mesh SEGMENTS SIDES\n");
    return 2;
  }
  lumaknot::KnotSpec knot;
  knot.segments = std::atoi(argv[1]);
  knot.sides = std::atoi(argv[2]);
  const lumaknot::TriangleMesh mesh = knot_mesh(knot);
  const auto bytes = [](const auto& array) { return array.size() * sizeof(array[0]); };
  fmt::print("{}\n",
             bytes(mesh.positions) + bytes(mesh.normals) + bytes(mesh.uvs) + bytes(mesh.triangles));
}
