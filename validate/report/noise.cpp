#include "validate/noise.h"

#include <fmt/format.h>

#include <algorithm>

#include "validate/compare/noise_words.h"
#include "validate/report/forms.h"

namespace lumaknot::validate {
namespace {

/// The shots that were tested, by index.
std::vector<std::size_t> tested_shots(const RendererResult& result) {
  std::vector<std::size_t> tested;
  for (std::size_t i = 0; i < result.shots.size(); ++i) {
    if (!result.shots[i].noise.scales.empty()) tested.push_back(i);
  }
  return tested;
}

double share_of(const NoiseTest& test) { return test.scales[worst_scale(test)].worst.share(); }

/// "a bias above 8e-05 of the whole picture, ... or 0.12 of a pixel would have been seen": of the
/// picture that shows the least.
std::string seen_text(const RendererResult& result, const std::vector<std::size_t>& tested) {
  const auto largest = [&](std::size_t scale) {
    double seen = 0;
    for (const std::size_t i : tested) {
      seen = std::max(seen, result.shots[i].noise.scales[scale].seen);
    }
    return seen;
  };
  const NoiseTest& any = result.shots[tested.front()].noise;
  const std::size_t last = any.scales.size() - 1, middle = std::min<std::size_t>(2, last);
  std::string text = fmt::format("a bias above {:.1g} of the whole picture", largest(last));
  if (middle < last) {
    text += fmt::format(", {:.1g} of {}", largest(middle), scale_name(any, middle));
  }
  return text + fmt::format(" or {:.1g} of a pixel would have been seen", largest(0));
}

}  // namespace

std::string noise_summary(const Validation& validation, const RendererResult& result) {
  const std::vector<std::size_t> tested = tested_shots(result);
  if (tested.empty() || !validation.sampling) return {};
  const auto test_of = [&](std::size_t i) -> const NoiseTest& { return result.shots[i].noise; };
  const std::size_t worst =
      *std::ranges::max_element(tested, {}, [&](std::size_t i) { return share_of(test_of(i)); });
  const std::size_t scale = worst_scale(test_of(worst));
  double noise = 0;
  for (const std::size_t i : tested) noise = std::max(noise, test_of(i).scales.front().noise);
  const bool agreed = share_of(test_of(worst)) <= 1;
  const std::string found =
      agreed ? fmt::format("within its noise, at most {:.0f} % of what is admitted, by {} of {}",
                           100 * share_of(test_of(worst)), scale_name(test_of(worst), scale),
                           validation.shots[worst].name)
             : fmt::format("beyond its noise, most in {}: {}", validation.shots[worst].name,
                           finding_text(test_of(worst), scale));
  std::string text = fmt::format("{} samples: {}; family error {}, noise {:.2g} per pixel; {}",
                                 validation.sampling->samples, found, kFamilyError, noise,
                                 seen_text(result, tested));
  const Judged& last = result.shots[tested.back()];
  if (last.denoised) {
    text +=
        fmt::format("; {} {}", validation.shots[tested.back()].name, denoised_text(*last.denoised));
  }
  return text;
}

}  // namespace lumaknot::validate
