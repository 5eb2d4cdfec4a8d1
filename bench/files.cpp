// Mesh files of 10^6 triangles in the current folder, compared to a plain write() of as many bytes
// and to OpenMesh's own writer.
#include <fcntl.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <filesystem>

#include "bench/knot.h"
#include "exporters/mesh/file.h"
#include "meshgen/knot_mesh.h"
#include "system/atomic_file.h"

namespace lumaknot::bench {
namespace {

namespace fs = std::filesystem;

void tell_speed(benchmark::State& state, const fs::path& path) {
  if (!fs::exists(path)) return;
  const auto bytes = std::int64_t(fs::file_size(path));
  state.SetBytesProcessed(bytes * std::int64_t(state.iterations()));
  state.counters["bytes"] = double(bytes);
}

void write_knot(benchmark::State& state, const char* path, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const TriangleMesh mesh = knot_mesh(knot_of(kMillion));
  guarded(state, [&] {
    for (auto _ : state) write_mesh(path, mesh, {}, "--output");
  });
  tell_speed(state, path);
}
BENCHMARK_CAPTURE(write_knot, ply_one_thread, "knot.ply", 1)->Apply(repeated);
BENCHMARK_CAPTURE(write_knot, ply_two_threads, "knot.ply", 2)->Apply(repeated);
BENCHMARK_CAPTURE(write_knot, glb_one_thread, "knot.glb", 1)->Apply(repeated);
BENCHMARK_CAPTURE(write_knot, glb_two_threads, "knot.glb", 2)->Apply(repeated);
BENCHMARK_CAPTURE(write_knot, obj_one_thread, "knot.obj", 1)->Apply(repeated);
BENCHMARK_CAPTURE(write_knot, obj_two_threads, "knot.obj", 2)->Apply(repeated);

/// Writes `bytes` next to `path` and renames, as write_mesh() does, and nothing else.
void write_plain(const fs::path& path, std::string_view bytes) {
  const fs::path temporary = "plain.part";
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0) throw Error("plain.part can't be written; run in a folder that can be");
  while (!bytes.empty()) {
    const ssize_t done = ::write(file, bytes.data(), bytes.size());
    if (done < 0) throw Error("plain.part can't be written; is the disk full?");
    bytes.remove_prefix(std::size_t(done));
  }
  ::close(file);
  fs::rename(temporary, path);
}

void write_bytes(benchmark::State& state) {
  guarded(state, [&] {
    const fs::path path = "plain.ply";
    write_mesh(path, knot_mesh(knot_of(kMillion)), {}, "--output");
    const std::string bytes = read_file(path, "mesh");
    for (auto _ : state) write_plain(path, bytes);
    tell_speed(state, path);
  });
}
BENCHMARK(write_bytes)->Apply(repeated);

struct FlatTraits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = OpenMesh::Vec2d;
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::TexCoord2D);
};
using FlatMesh = OpenMesh::TriMesh_ArrayKernelT<FlatTraits>;

FlatMesh to_open_mesh(const TriangleMesh& mesh) {
  FlatMesh result;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d &p = mesh.positions[i], &n = mesh.normals[i];
    const auto vertex = result.add_vertex({p.x, p.y, p.z});
    result.set_normal(vertex, {n.x, n.y, n.z});
    result.set_texcoord2D(vertex, {mesh.uvs[i].u, mesh.uvs[i].v});
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    result.add_face(FlatMesh::VertexHandle(int(a)), FlatMesh::VertexHandle(int(b)),
                    FlatMesh::VertexHandle(int(c)));
  }
  return result;
}

/// OpenMesh's writer only; building its mesh is not counted.
void write_open_mesh(benchmark::State& state) {
  const std::string path = "openmesh.obj";
  const FlatMesh mesh = to_open_mesh(knot_mesh(knot_of(kMillion)));
  constexpr std::streamsize kDigits = 9;  // as ours: distinguishes all float32 numbers
  const OpenMesh::IO::Options options =
      OpenMesh::IO::Options::VertexNormal | OpenMesh::IO::Options::VertexTexCoord;
  for (auto _ : state) {
    if (!OpenMesh::IO::write_mesh(mesh, path, options, kDigits)) state.SkipWithError("not written");
  }
  tell_speed(state, path);
}
BENCHMARK(write_open_mesh)->Apply(repeated)->Iterations(1);

void read_knot(benchmark::State& state, const char* path, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  guarded(state, [&] {
    write_mesh(path, knot_mesh(knot_of(kMillion)), {}, "--output");
    for (auto _ : state) benchmark::DoNotOptimize(read_mesh(path, true, "mesh"));
    tell_speed(state, path);
  });
}
BENCHMARK_CAPTURE(read_knot, ply_two_threads, "read.ply", 2)->Apply(repeated)->Iterations(1);
BENCHMARK_CAPTURE(read_knot, glb_two_threads, "read.glb", 2)->Apply(repeated)->Iterations(1);
BENCHMARK_CAPTURE(read_knot, obj_two_threads, "read.obj", 2)->Apply(repeated)->Iterations(1);

}  // namespace
}  // namespace lumaknot::bench
