#include "study/paper/formula_times.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include "render/fast/renderer.h"
#include "scene/presets.h"
#include "system/known.h"
#include "system/process.h"

namespace lumaknot::paper {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::unique_ptr<fast::Renderer> renderer_of(Scene scene, const std::string& formula) {
  scene.view.material = known(with_formula(scene.view.material, formula));
  fast::Options options;
  options.filter = Filter::kTrilinear;
  options.threads = 1;
  return std::make_unique<fast::Renderer>(scene, options);
}

}  // namespace

std::vector<FormulaTime> time_formulas(const Scene& scene, const std::vector<std::string>& formulas,
                                       double seconds, const Progress& progress) {
  constexpr std::size_t kMinRounds = 3;
  std::vector<std::unique_ptr<fast::Renderer>> renderers;
  Grid<fast::Rgba8> image;
  for (const std::string& formula : formulas) {
    renderers.push_back(renderer_of(scene, formula));
    renderers.back()->draw(image);  // the first frame allocates the memory
  }
  std::vector<std::vector<double>> times(formulas.size());
  const auto start = Clock::now();
  for (double share = 0; share < 1 || times.front().size() < kMinRounds;) {
    for (std::size_t i = 0; i < renderers.size(); ++i) {
      check_interrupted();
      const auto before = Clock::now();
      renderers[i]->draw(image);
      times[i].push_back(milliseconds_since(before));
    }
    share = seconds > 0 ? milliseconds_since(start) / 1000 / seconds : 1;
    if (progress) progress(std::min(share, 1.0));
  }
  std::vector<FormulaTime> result;
  result.reserve(formulas.size());
  for (std::size_t i = 0; i < formulas.size(); ++i) {
    result.push_back(
        {formulas[i], measure::spread_of(times[i]), 1 - measure::paired_ratio(times[0], times[i])});
  }
  return result;
}

}  // namespace lumaknot::paper
