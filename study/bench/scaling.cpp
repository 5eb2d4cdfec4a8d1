#include "study/bench/scaling.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "meshgen/knot_mesh.h"
#include "render/fast/renderer.h"
#include "system/process.h"

namespace lumaknot::bench {
namespace {

constexpr std::size_t kMinFrames = 5;

/// A step before it is measured.
struct Work {
  std::string name;
  double amount = 0;
  Scene scene;
  int samples = 1;
};

measure::Spread time_frames(const Work& work, const ScalingOptions& options) {
  using Clock = std::chrono::steady_clock;
  fast::Options fast;
  fast.samples = work.samples;
  fast.threads = options.threads;
  fast.filter = Filter::kTrilinear;
  fast::Renderer renderer(work.scene, fast);
  Grid<fast::Rgba8> image;
  renderer.draw(image);  // the first frame allocates the memory
  std::vector<double> times;
  const auto start = Clock::now();
  const auto elapsed = [](Clock::time_point since) {
    return std::chrono::duration<double>(Clock::now() - since).count();
  };
  while (times.size() < kMinFrames || elapsed(start) < options.seconds) {
    const auto before = Clock::now();
    renderer.draw(image);
    times.push_back(1000 * elapsed(before));
    check_interrupted();
  }
  return measure::spread_of(times);
}

std::vector<Work> growing_triangles(const Scene& scene, const KnotSpec& knot) {
  std::vector<Work> all;
  for (const double factor : {0.1, 1.0, 10.0, 100.0}) {
    KnotSpec grown = knot;
    grown.segments = std::max(3, int(std::lround(knot.segments * std::sqrt(factor))));
    grown.sides = std::max(3, int(std::lround(knot.sides * std::sqrt(factor))));
    Work work{{}, 0, scene};
    work.scene.mesh = knot_mesh(grown);
    work.amount = double(work.scene.mesh.triangles.size());
    work.name = fmt::format("{} triangles", work.scene.mesh.triangles.size());
    all.push_back(std::move(work));
  }
  return all;
}

std::vector<Work> growing_pixels(const Scene& scene) {
  std::vector<Work> all;
  for (const double factor : {0.25, 0.5, 1.0, 2.0, 4.0, 8.0}) {
    Work work{{}, 0, scene};
    ImageSpec& image = work.scene.view.image;
    image.width = std::max(1, int(image.width * factor));
    image.height = std::max(1, int(image.height * factor));
    work.amount = double(image.width) * image.height;
    work.name = fmt::format("{} x {} pixels", image.width, image.height);
    all.push_back(std::move(work));
  }
  return all;
}

std::vector<Work> growing_samples(const Scene& scene) {
  std::vector<Work> all;
  for (const int samples : {1, 2, 4, 6, 8, 16}) {
    all.push_back({fmt::format("{} samples", samples), double(samples), scene, samples});
  }
  return all;
}

}  // namespace

double slope_of(const Scaling& scaling, std::size_t i) {
  const ScalingStep &from = scaling.steps[i - 1], &to = scaling.steps[i];
  return std::log(to.milliseconds.median / from.milliseconds.median) /
         std::log(to.work / from.work);
}

std::vector<Scaling> measure_scaling(const Scene& scene, const MeshSpec& mesh,
                                     const ScalingOptions& options, const Progress& progress) {
  using Make = std::function<std::vector<Work>()>;
  std::vector<std::pair<std::string, Make>> kinds;
  if (const auto* knot = std::get_if<KnotSpec>(&mesh)) {
    kinds.emplace_back("triangles", [&scene, knot] { return growing_triangles(scene, *knot); });
  }
  kinds.emplace_back("pixels", [&scene] { return growing_pixels(scene); });
  kinds.emplace_back("samples", [&scene] { return growing_samples(scene); });
  std::vector<Scaling> all;
  for (const auto& [name, make] : kinds) {
    Scaling scaling{name, {}};
    const std::vector<Work> works = make();
    for (const Work& work : works) {
      scaling.steps.push_back({work.name, work.amount, time_frames(work, options)});
      if (progress) {
        progress((double(all.size()) + double(scaling.steps.size()) / double(works.size())) /
                 double(kinds.size()));
      }
    }
    all.push_back(std::move(scaling));
  }
  return all;
}

}  // namespace lumaknot::bench
