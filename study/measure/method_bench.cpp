#include "study/measure/method_bench.h"

#include "meshgen/knot_mesh.h"

namespace lumaknot::measure {
namespace {

constexpr std::size_t kMaxVertices = 3'000'000;  // of the meshes that are kept

/// Whether `mesh` is a knot with another grid than `own`.
bool is_regridded(const MeshSpec& mesh, const MeshSpec& own) {
  const auto *knot = std::get_if<KnotSpec>(&mesh), *before = std::get_if<KnotSpec>(&own);
  return knot && (knot->segments != before->segments || knot->sides != before->sides);
}

}  // namespace

const Scene& MethodBench::scene_of(const Method& method) {
  const MeshSpec mesh = method_mesh(method, mesh_);
  if (!is_regridded(mesh, mesh_)) return scene_;
  const std::pair grid{method.segments, method.sides};
  if (const auto known = scenes_.find(grid); known != scenes_.end()) return known->second;
  std::size_t vertices = 0;
  for (const auto& [size, scene] : scenes_) vertices += scene.mesh.positions.size();
  if (vertices > kMaxVertices) scenes_.clear();
  Scene scene{knot_mesh(std::get<KnotSpec>(mesh)), scene_.texture, scene_.view};
  return scenes_.emplace(grid, std::move(scene)).first->second;
}

Image MethodBench::draw(const Method& method) {
  return MethodRenderer(method, scene_of(method)).image();
}

FrameRound MethodBench::time(const Method& method) {
  MethodRenderer renderer(method, scene_of(method), kTimedThreads);
  return time([&] { renderer.draw(); });
}

FrameRound MethodBench::time(const DrawFrame& frame) {
  if (!baseline_) {
    baseline_ = make_baseline_();
    baseline_();  // the first frame allocates the memory
  }
  return time_round(frame, baseline_);
}

}  // namespace lumaknot::measure
