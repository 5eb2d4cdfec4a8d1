#include "study/planning/workshop.h"

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <limits>

#include "meshgen/knot_mesh.h"
#include "render/fast_renderer.h"
#include "study/statistics.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

constexpr std::size_t kMostVertices = 3'000'000;  // of the meshes that are kept
constexpr std::size_t kSlowRounds = 3;            // times of slow frames are near no other's

/// The samples of coverage that come nearest to the scene's.
int multisample_of(const ImageSpec& image) {
  const int samples = image.samples * image.samples;
  return samples >= 16 ? 16 : samples >= 8 ? 8 : samples;
}

FastRenderer as_it_is(Scene scene) {
  FastOptions options;
  options.samples = multisample_of(scene.view.image);
  options.threads = kTimedThreads;
  scene.view.image.samples = 1;
  return FastRenderer(scene, options);
}

}  // namespace

/// The scene as it is, drawn fast.
class Workshop::Beside {
 public:
  explicit Beside(const Scene& scene) : renderer_(as_it_is(scene)) { draw(); }
  void draw() { renderer_.draw(image_); }

 private:
  FastRenderer renderer_;
  Grid<Rgba8> image_;
};

Workshop::Workshop(const Lean& lean, const KnotSpec& knot, const Scene& scene, const Judge& judge,
                   Notebook& notebook)
    : lean_(lean), knot_(knot), scene_(scene), judge_(judge), notebook_(notebook) {}

Workshop::~Workshop() = default;

const Scene& Workshop::scene_of(const Method& method) {
  const std::pair grid{method.segments, method.sides};
  if (const auto known = scenes_.find(grid); known != scenes_.end()) return known->second;
  std::size_t vertices = 0;
  for (const auto& [size, scene] : scenes_) vertices += scene.mesh.positions.size();
  if (vertices > kMostVertices) scenes_.clear();
  const MeshSpec mesh = method_mesh(method, knot_);
  Scene scene{knot_mesh(std::get<KnotSpec>(mesh)), lean_.texture, lean_.view};
  return scenes_.emplace(grid, std::move(scene)).first->second;
}

Image Workshop::draw(const Method& method) {
  return MethodRenderer(method, scene_of(method)).image();
}

Image Workshop::draw_beside() const {
  Image image;
  as_it_is(scene_).draw(image);
  return image;
}

const ToleranceResult& Workshop::judgement(const Method& method) {
  return notebook_.judgement(method_name(method), [&] {
    check_interrupted();
    return judge_.judge(draw(method));
  });
}

void Workshop::round(const std::string& name, const DrawFrame& frame) {
  check_interrupted();
  if (!beside_) beside_ = std::make_unique<Beside>(scene_);
  notebook_.add(name, time_round(frame, [&] { beside_->draw(); }));
}

void Workshop::time(std::span<const Method> methods, int rounds) {
  for (int i = 0; i < rounds; ++i) {
    for (const Method& method : methods) {
      const std::string name = method_name(method);
      const std::vector<FrameRound>& had = notebook_.rounds(name);
      if (had.size() > std::size_t(i)) continue;
      if (had.size() >= kSlowRounds && had.back().milliseconds > kSlowFrame) continue;
      // Made anew each round: where its memory lies is part of its time.
      MethodRenderer renderer(method, scene_of(method), kTimedThreads);
      round(name, [&] { renderer.draw(); });
    }
  }
}

double Workshop::ratio(const std::string& name) {
  std::vector<double> ratios;
  for (const FrameRound& round : notebook_.rounds(name)) ratios.push_back(round.ratio);
  return ratios.empty() ? std::numeric_limits<double>::infinity() : median(std::move(ratios));
}

double Workshop::least_ratio(const Method& method) {
  double least = std::numeric_limits<double>::infinity();
  for (const FrameRound& round : notebook_.rounds(method_name(method))) {
    least = std::min(least, round.ratio);
  }
  return least;
}

double Workshop::milliseconds_beside() const {
  std::vector<double> times;
  for (const auto& [name, rounds] : notebook_.all_rounds()) {
    for (const FrameRound& round : rounds) times.push_back(round.milliseconds / round.ratio);
  }
  return times.empty() ? 0 : median(std::move(times));
}

double Workshop::milliseconds(const std::string& name) {
  return ratio(name) * milliseconds_beside();
}

void Workshop::time_reference(int rounds) {
  oneapi::tbb::task_arena arena(kTimedThreads);
  const std::size_t enough = std::min(std::size_t(rounds), kSlowRounds);
  while (notebook_.rounds(kReference).size() < enough) {
    round(kReference,
          [&] { arena.execute([&] { render(scene_, [](double) { check_interrupted(); }); }); });
  }
}

}  // namespace lumaknot
