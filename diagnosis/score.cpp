#include "diagnosis/score.h"

#include <algorithm>
#include <cmath>

namespace lumaknot::diagnosis {

std::vector<double> errors_of(const Target& target, const Drawn& ours) {
  std::vector<double> errors(target.colors.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double color = largest_magnitude(ours.colors[i] - target.colors[i]);
    const double coverage = std::abs(ours.coverage[i] - target.coverage[i]);
    errors[i] = target.facts.has_alpha ? std::max(color, coverage) : color;
    if (!std::isfinite(errors[i])) errors[i] = 1e3;
  }
  return errors;
}

Score score_of(const Target& target, std::vector<double> errors, std::size_t pixels) {
  Score score;
  std::size_t noticed = 0;
  for (const double error : errors) {
    score.value += std::log1p(error * error / (target.facts.noise * target.facts.noise));
    noticed += error > 4 * target.facts.noise;
  }
  const double counted = double(std::max<std::size_t>(pixels, 1));
  score.value /= counted;
  score.explained = std::max(0.0, 1 - double(noticed) / counted);
  // The others, which neither picture covers, have no error: they come first.
  std::ranges::sort(errors);
  const auto at = [&](double share) {
    const double from_end = (1 - share) * counted;
    return errors[errors.size() - 1 - std::min(errors.size() - 1, std::size_t(from_end))];
  };
  score.median = at(0.5);
  score.p999 = at(0.999);
  return score;
}

}  // namespace lumaknot::diagnosis
