#include "study/plan/trials.h"

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "render/fast/renderer.h"
#include "study/measure/statistics.h"
#include "system/process.h"

namespace lumaknot::plan {
namespace {

/// The number of coverage samples that is closest to the scene's.
int multisample_of(const ImageSpec& image) {
  const int samples = image.samples * image.samples;
  return samples >= 16 ? 16 : samples >= 8 ? 8 : samples;
}

fast::Renderer as_it_is(Scene scene) {
  fast::Options options;
  options.samples = multisample_of(scene.view.image);
  options.threads = measure::kTimedThreads;
  scene.view.image.samples = 1;
  return fast::Renderer(scene, options);
}

std::vector<double> milliseconds_of(std::span<const measure::FrameRound> rounds) {
  std::vector<double> times;
  for (const measure::FrameRound& round : rounds) times.push_back(round.milliseconds);
  return times;
}

}  // namespace

const ToleranceResult& Trials::result(const measure::Method& method) {
  return store_.result(measure::method_name(method), [&] {
    check_interrupted();
    return checker_.check(bench_.draw(method));
  });
}

void Trials::time(std::span<const measure::Method> methods, int rounds) {
  for (int i = 0; i < rounds; ++i) {
    for (const measure::Method& method : methods) {
      const std::string name = measure::method_name(method);
      if (!measure::needs_round(milliseconds_of(store_.rounds(name)), std::size_t(i))) continue;
      check_interrupted();
      store_.add(name, bench_.time(method));
    }
  }
}

double Trials::ratio(const std::string& name) {
  std::vector<double> ratios;
  for (const measure::FrameRound& round : store_.rounds(name)) ratios.push_back(round.ratio);
  return ratios.empty() ? std::numeric_limits<double>::infinity()
                        : measure::median(std::move(ratios));
}

double Trials::min_ratio(const measure::Method& method) {
  double min = std::numeric_limits<double>::infinity();
  for (const measure::FrameRound& round : store_.rounds(measure::method_name(method))) {
    min = std::min(min, round.ratio);
  }
  return min;
}

double Trials::baseline_milliseconds() const {
  std::vector<double> times;
  for (const auto& [name, rounds] : store_.all_rounds()) {
    for (const measure::FrameRound& round : rounds)
      times.push_back(round.milliseconds / round.ratio);
  }
  return times.empty() ? 0 : measure::median(std::move(times));
}

double Trials::milliseconds(const std::string& name) {
  return ratio(name) * baseline_milliseconds();
}

void Trials::time_reference(const Scene& scene, int rounds) {
  oneapi::tbb::task_arena arena(measure::kTimedThreads);
  const auto frame = [&] {
    arena.execute([&] { render(scene, [](double) { check_interrupted(); }); });
  };
  const std::size_t enough = std::min(std::size_t(rounds), measure::kSlowRounds);
  while (store_.rounds(kReference).size() < enough) {
    check_interrupted();
    store_.add(kReference, bench_.time(frame));
  }
}

measure::DrawFrame fast_frame(const Scene& scene) {
  const std::shared_ptr<fast::Renderer> renderer(new fast::Renderer(as_it_is(scene)));
  return [renderer, image = std::make_shared<Grid<fast::Rgba8>>()] { renderer->draw(*image); };
}

Image fast_image(const Scene& scene) {
  Image image;
  as_it_is(scene).draw(image);
  return image;
}

}  // namespace lumaknot::plan
