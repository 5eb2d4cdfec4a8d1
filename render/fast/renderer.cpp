#include "render/fast/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/fast/clip.h"
#include "render/fast/frame_scene.h"
#include "render/fast/kernel.h"
#include "render/fast/thread_pool.h"
#include "system/error.h"

namespace lumaknot::fast {
namespace {

constexpr int kLargestSide = 256 * kTile;
constexpr std::size_t kMaxTriangles = std::size_t(1) << 28, kMaxVertices = kMaxTriangles;
constexpr std::size_t kVertexBatch = 2048;  // handed to a thread at once

void check(const Scene& scene, const Options& options) {
  const ImageSpec& image = scene.view.image;
  if (sample_pattern(options.samples).empty()) {
    throw Error(fmt::format("--multisample must be 1, 2, 4, 6, 8 or 16, got {}", options.samples));
  }
  if (image.samples != 1) {
    const int nearest = image.samples == 2 ? 4 : image.samples == 3 ? 8 : 16;
    throw Error(fmt::format("image.samples must be 1 here, got {}; use --multisample {} instead",
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
  if (scene.mesh.triangles.size() > kMaxTriangles || scene.mesh.positions.size() > kMaxVertices) {
    throw Error(
        fmt::format("the mesh may have at most {} triangles and vertices here, got {} and {}",
                    kMaxTriangles, scene.mesh.triangles.size(), scene.mesh.positions.size()));
  }
  if (options.level > best_simd_level())
    throw Error("--simd: this processor lacks these instructions; omit the option");
}

TileMemory tile_memory(std::size_t samples) {
  constexpr std::size_t kPlane = std::size_t(kTile) * kTile;
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
    if (run.tiles[i] == span.first) return work(span.first);  // the common case
    for (std::uint32_t y = 0; y <= span.down; ++y) {
      for (std::uint32_t x = 0; x <= span.right; ++x) {
        work(span.first + y * std::uint32_t(columns) + x);
      }
    }
  };
  run.begins.assign(std::size_t(columns) * std::size_t(rows) + 1, 0);
  for (std::size_t i = 0; i < run.found; ++i) each_tile(i, [&](std::size_t t) { ++run.begins[t]; });
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : run.begins) begin = sum += begin;  // for now the ends
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

class Renderer::Frame {
 public:
  Frame(const Scene& scene, const Options& options)
      : data_(frame_data(scene, options)),
        kernel_(make_kernel(data_)),
        pool_(options.threads > 0 ? options.threads
                                  : int(std::max(1u, std::thread::hardware_concurrency()))) {
    data_.memories.assign(std::size_t(pool_.size()), tile_memory(data_.pattern.size()));
  }

  template <class Pixel>
  void draw(Grid<Pixel>& image) {
    if (image.width != data_.width || image.height != data_.height) {
      image = Grid<Pixel>(data_.width, data_.height);
    }
    put(image);
    project();
    pool_.run(int(data_.runs.size()), list_);
    pool_.run(data_.columns * data_.rows, draw_);
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
    pool_.run(int((data_.vertex_count + kVertexBatch - 1) / kVertexBatch), transform_);
    if (!all_inside_) pool_.run(int(data_.runs.size()), find_cut_);
    for (Run& run : data_.runs) {
      const std::size_t before = data_.triangles.size();
      if (!all_inside_) clip_triangles(data_, run.cut);
      make_room(run, data_.triangles.size() - before);
    }
  }

  /// Finds a run's candidates: its triangles, or the pieces of those that were clipped.
  static void make_room(Run& run, std::size_t pieces) {
    const std::size_t max = run.last - run.first + pieces + kPadding;
    if (run.candidates.size() >= max) return;
    run.candidates.resize(max);
    run.tiles.resize(max);
  }

  FrameData data_;
  std::unique_ptr<Kernel> kernel_;
  ThreadPool pool_;
  std::atomic<bool> all_inside_ = true;
  // Kept, since creating one may allocate.
  const std::function<void(int, int)> transform_ = [this](int i, int) {
    const std::size_t begin = std::size_t(i) * kVertexBatch;
    const std::size_t end = std::min(begin + kVertexBatch, data_.vertex_count);
    if (!kernel_->transform(begin, end)) all_inside_ = false;
    if (!data_.terms.empty()) kernel_->light(begin, end);
  };
  const std::function<void(int, int)> find_cut_ = [this](int i, int) {
    find_cut(data_, data_.runs[std::size_t(i)]);
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

Renderer::Renderer(const Scene& scene, const Options& options) {
  check(scene, options);
  frame_ = std::make_unique<Frame>(scene, options);
}

Renderer::~Renderer() = default;

void Renderer::draw(Grid<Rgba8>& image) { frame_->draw(image); }
void Renderer::draw(Image& image) { frame_->draw(image); }

}  // namespace lumaknot::fast
