#include "study/plan/trials.h"

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "render/fast/renderer.h"
#include "study/measure/statistics.h"
#include "system/process.h"

namespace lumaknot {
namespace {

/// The number of coverage samples that is closest to the scene's.
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

std::vector<double> milliseconds_of(std::span<const FrameRound> rounds) {
  std::vector<double> times;
  for (const FrameRound& round : rounds) times.push_back(round.milliseconds);
  return times;
}

}  // namespace

const ToleranceResult& Trials::result(const Method& method) {
  return store_.result(method_name(method), [&] {
    check_interrupted();
    return checker_.check(bench_.draw(method));
  });
}

void Trials::time(std::span<const Method> methods, int rounds) {
  for (int i = 0; i < rounds; ++i) {
    for (const Method& method : methods) {
      const std::string name = method_name(method);
      if (!needs_round(milliseconds_of(store_.rounds(name)), std::size_t(i))) continue;
      check_interrupted();
      store_.add(name, bench_.time(method));
    }
  }
}

double Trials::ratio(const std::string& name) {
  std::vector<double> ratios;
  for (const FrameRound& round : store_.rounds(name)) ratios.push_back(round.ratio);
  return ratios.empty() ? std::numeric_limits<double>::infinity() : median(std::move(ratios));
}

double Trials::min_ratio(const Method& method) {
  double min = std::numeric_limits<double>::infinity();
  for (const FrameRound& round : store_.rounds(method_name(method))) {
    min = std::min(min, round.ratio);
  }
  return min;
}

double Trials::baseline_milliseconds() const {
  std::vector<double> times;
  for (const auto& [name, rounds] : store_.all_rounds()) {
    for (const FrameRound& round : rounds) times.push_back(round.milliseconds / round.ratio);
  }
  return times.empty() ? 0 : median(std::move(times));
}

double Trials::milliseconds(const std::string& name) {
  return ratio(name) * baseline_milliseconds();
}

void Trials::time_reference(const Scene& scene, int rounds) {
  oneapi::tbb::task_arena arena(kTimedThreads);
  const auto frame = [&] {
    arena.execute([&] { render(scene, [](double) { check_interrupted(); }); });
  };
  const std::size_t enough = std::min(std::size_t(rounds), kSlowRounds);
  while (store_.rounds(kReference).size() < enough) {
    check_interrupted();
    store_.add(kReference, bench_.time(frame));
  }
}

DrawFrame fast_frame(const Scene& scene) {
  const std::shared_ptr<FastRenderer> renderer(new FastRenderer(as_it_is(scene)));
  return [renderer, image = std::make_shared<Grid<Rgba8>>()] { renderer->draw(*image); };
}

Image fast_image(const Scene& scene) {
  Image image;
  as_it_is(scene).draw(image);
  return image;
}

}  // namespace lumaknot
