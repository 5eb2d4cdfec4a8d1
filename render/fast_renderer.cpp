#include "render/fast_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/clip.h"
#include "render/crew.h"
#include "render/kernel.h"
#include "scene/error.h"

namespace lumaknot {
namespace {

constexpr int kLargestSide = 256 * kTile;
constexpr std::size_t kMostTriangles = std::size_t(1) << 28, kMostVertices = kMostTriangles;
constexpr std::size_t kVertexBatch = 2048;  // handed to a thread at once
constexpr std::size_t kShortestRun = 1024, kMostRuns = 64;
constexpr std::size_t kPadding = 16;  // what a packet may reach behind the last

void check(const Scene& scene, const FastOptions& options) {
  const ImageSpec& image = scene.view.image;
  if (sample_pattern(options.samples).empty()) {
    throw Error(fmt::format("--multisample must be 1, 2, 4, 6, 8 or 16, got {}", options.samples));
  }
  if (image.samples != 1) {
    const int nearest = image.samples == 2 ? 4 : image.samples == 3 ? 8 : 16;
    throw Error(
        fmt::format("image.samples must be 1 here, got {}; use --multisample {} in its place",
                    image.samples, nearest));
  }
  if (image.width > kLargestSide || image.height > kLargestSide) {
    throw Error(fmt::format("image must be at most {0} x {0} here, got {1} x {2}", kLargestSide,
                            image.width, image.height));
  }
  const auto* texture = std::get_if<TextureImage>(&scene.texture);
  if (texture && (texture->width > kLargestSide || texture->height > kLargestSide)) {
    throw Error(fmt::format("texture must be at most {0} x {0} here, got {1} x {2}", kLargestSide,
                            texture->width, texture->height));
  }
  if (scene.mesh.triangles.size() > kMostTriangles || scene.mesh.positions.size() > kMostVertices) {
    throw Error(
        fmt::format("the mesh may have at most {} triangles and vertices here, got {} and {}",
                    kMostTriangles, scene.mesh.triangles.size(), scene.mesh.positions.size()));
  }
  if (options.level > best_simd_level()) throw Error("this processor has no such instructions");
}

/// Lengths that single precision holds wherever a scene lies and however large it is: from the eye,
/// in the power of two that is nearest to the target's distance, so that nothing is rounded.
class EyeLengths {
 public:
  explicit EyeLengths(const Camera& camera)
      : eye_(camera.position),
        scale_(std::exp2(-std::round(std::log2(length(camera.target - camera.position))))) {}

  Vec3d operator()(const Vec3d& position) const { return (position - eye_) * scale_; }

  Camera operator()(Camera camera) const {
    camera.target = (*this)(camera.target);
    camera.position = {};
    return camera;
  }

  Lighting<double> operator()(Lighting<double> lighting) const {
    lighting.eye_position = {};
    for (LightNumbers<double>& light : lighting.lights) {
      light.position = (*this)(light.position);
      light.linear /= scale_;
      light.quadratic /= scale_ * scale_;
    }
    return lighting;
  }

 private:
  Vec3d eye_;
  double scale_;
};

void copy_mesh(FrameData& data, const TriangleMesh& mesh, const EyeLengths& lengths) {
  const std::size_t count = mesh.positions.size();
  data.vertex_count = count;
  data.triangle_count = mesh.triangles.size();
  for (Bulk<double>* axis : {&data.xs, &data.ys, &data.zs}) axis->assign(count + kPadding, 0);
  data.records.resize(count);
  data.points.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d p = lengths(mesh.positions[i]), &n = mesh.normals[i];
    data.xs[i] = p.x, data.ys[i] = p.y, data.zs[i] = p.z;
    data.records[i] = {0,
                       0,
                       0,
                       {float(n.x), float(n.y), float(n.z)},
                       {float(mesh.uvs[i].u), float(mesh.uvs[i].v)}};
  }
  for (std::size_t i = count; i < count + kPadding && count > 0; ++i) {
    data.xs[i] = data.xs[count - 1], data.ys[i] = data.ys[count - 1],
    data.zs[i] = data.zs[count - 1];
  }
  data.triangles.resize(mesh.triangles.size());
  std::ranges::transform(mesh.triangles, data.triangles.begin(), [](const Triangle& t) {
    return std::array<std::uint32_t, 4>{t[0], t[1], t[2], 0};
  });
}

std::vector<Run> runs_of(std::size_t triangles) {
  const std::size_t length = std::max(kShortestRun, (triangles + kMostRuns - 1) / kMostRuns);
  std::vector<Run> runs;
  for (std::size_t first = 0; first < triangles; first += length) {
    Run run;
    run.first = std::uint32_t(first);
    run.last = std::uint32_t(std::min(first + length, triangles));
    runs.push_back(std::move(run));
  }
  return runs;
}

FrameData frame_data(const Scene& scene, const FastOptions& options) {
  FrameData data;
  const EyeLengths lengths(scene.view.camera);
  const Camera camera = lengths(scene.view.camera);
  data.width = scene.view.image.width;
  data.height = scene.view.image.height;
  data.columns = (data.width + kTile - 1) / kTile;
  data.rows = (data.height + kTile - 1) / kTile;
  data.options = options;
  data.pattern = sample_pattern(options.samples);
  data.projection = Projection(camera, data.width, data.height);
  const auto ray = [&](double x, double y) {
    return data.projection.to_world(data.projection.ray(x, y));
  };
  data.corner_ray = ray(0, 0);
  data.ray_x = ray(1, 0) - data.corner_ray;
  data.ray_y = ray(0, 1) - data.corner_ray;
  data.near = near_depth(camera);
  data.shot = {"final", Stage::kFinal, scene.view.material};
  data.lighting = lengths(lighting_of<double>(scene.view, scene.view.material));
  copy_mesh(data, scene.mesh, lengths);
  data.runs = runs_of(data.triangle_count);
  if (scene.view.material.rate == Rate::kVertex) data.terms.resize(data.vertex_count);
  data.texture = make_mipmap(scene.texture, scene.view.material, options.wrapping,
                             options.filter == Filter::kTrilinear);
  return data;
}

TileMemory tile_memory(std::size_t samples) {
  constexpr std::size_t kPlane = kTile * kTile;
  TileMemory memory;
  memory.nearest.resize(2 * (samples * kPlane + kPadding));
  memory.colors.resize(kPlane * 4);
  memory.touched.resize(kPlane);
  return memory;
}

std::unique_ptr<Kernel> make_kernel(FrameData& data) {
  switch (data.options.level) {
#ifdef __x86_64__
    case SimdLevel::kAvx512:
      return make_avx512_kernel(data);
    case SimdLevel::kAvx2:
      return make_avx2_kernel(data);
#endif
    default:
      return make_baseline_kernel(data);
  }
}

/// The candidates of the run, tile by tile.
void sort_by_tile(Run& run, int columns, int rows) {
  const auto each_tile = [&](std::size_t i, const auto& work) {
    const TileSpan span(run.tiles[i]);
    if (run.tiles[i] == span.first) return work(span.first);  // most
    for (std::uint32_t y = 0; y <= span.down; ++y) {
      for (std::uint32_t x = 0; x <= span.right; ++x) {
        work(span.first + y * std::uint32_t(columns) + x);
      }
    }
  };
  run.begins.assign(std::size_t(columns) * std::size_t(rows) + 1, 0);
  for (std::size_t i = 0; i < run.found; ++i) each_tile(i, [&](std::size_t t) { ++run.begins[t]; });
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : run.begins) begin = sum += begin;  // the ends, for now
  run.listed.resize(sum);
  for (std::size_t i = run.found; i-- > 0;) {
    each_tile(i, [&](std::size_t t) { run.listed[--run.begins[t]] = run.candidates[i]; });
  }
}

}  // namespace

SimdLevel best_simd_level() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512cd") &&
      __builtin_cpu_supports("avx512vl")) {
    return SimdLevel::kAvx512;
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return SimdLevel::kAvx2;
#endif
  return SimdLevel::kBaseline;
}

class FastRenderer::Frame {
 public:
  Frame(const Scene& scene, const FastOptions& options)
      : data_(frame_data(scene, options)),
        kernel_(make_kernel(data_)),
        crew_(options.threads > 0 ? options.threads
                                  : int(std::max(1u, std::thread::hardware_concurrency()))) {
    data_.memories.assign(std::size_t(crew_.size()), tile_memory(data_.pattern.size()));
  }

  template <class Pixel>
  void draw(Grid<Pixel>& image) {
    if (image.width != data_.width || image.height != data_.height) {
      image = Grid<Pixel>(data_.width, data_.height);
    }
    put(image);
    project();
    crew_.run(int(data_.runs.size()), list_);
    crew_.run(data_.columns * data_.rows, draw_);
  }

 private:
  void put(Grid<Rgba8>& image) { data_.bytes = &image, data_.floats = nullptr; }
  void put(Image& image) { data_.floats = &image, data_.bytes = nullptr; }

  void project() {
    data_.records.resize(data_.vertex_count);
    data_.points.resize(data_.vertex_count);
    data_.triangles.resize(data_.triangle_count);
    if (!data_.terms.empty()) data_.terms.resize(data_.vertex_count);
    data_.clipped.clear();
    all_inside_ = true;
    crew_.run(int((data_.vertex_count + kVertexBatch - 1) / kVertexBatch), transform_);
    if (!all_inside_) clip_triangles(data_);
    // A run's candidates are its triangles, or the pieces of those that were clipped.
    for (Run& run : data_.runs) {
      std::size_t most = run.last - run.first;
      for (const Clipped& c : data_.clipped) {
        most += c.triangle >= run.first && c.triangle < run.last ? c.count : 0;
      }
      if (run.candidates.size() >= most + kPadding) continue;
      run.candidates.resize(most + kPadding);
      run.tiles.resize(most + kPadding);
    }
  }

  FrameData data_;
  std::unique_ptr<Kernel> kernel_;
  Crew crew_;
  std::atomic<bool> all_inside_ = true;
  // Kept, since making one may allocate.
  const std::function<void(int, int)> transform_ = [this](int i, int) {
    const std::size_t begin = std::size_t(i) * kVertexBatch;
    const std::size_t end = std::min(begin + kVertexBatch, data_.vertex_count);
    if (!kernel_->transform(begin, end)) all_inside_ = false;
    if (!data_.terms.empty()) kernel_->light(begin, end);
  };
  const std::function<void(int, int)> list_ = [this](int i, int) {
    Run& run = data_.runs[std::size_t(i)];
    kernel_->list(run);
    sort_by_tile(run, data_.columns, data_.rows);
  };
  const std::function<void(int, int)> draw_ = [this](int tile, int worker) {
    kernel_->draw(tile, data_.memories[std::size_t(worker)]);
  };
};

FastRenderer::FastRenderer(const Scene& scene, const FastOptions& options) {
  check(scene, options);
  frame_ = std::make_unique<Frame>(scene, options);
}

FastRenderer::~FastRenderer() = default;

void FastRenderer::draw(Grid<Rgba8>& image) { frame_->draw(image); }
void FastRenderer::draw(Image& image) { frame_->draw(image); }

}  // namespace lumaknot
