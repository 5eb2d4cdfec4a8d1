#include "validate/compare/one_sided.h"

#include <cmath>
#include <numbers>

namespace lumaknot::validate {

double both_beyond(double deviations, double freedom) {
  // The variance is freedom / w, w of the chi-square distribution; summed over u = log(w /
  // freedom).
  const double half = freedom / 2, factor = std::log(half) * half - std::lgamma(half);
  const double step = 0.4 / std::sqrt(half + std::fmin(deviations * deviations, 16));
  double sum = 0;
  const double from = -3 - 50 / half;
  const int steps = int((4 - from) / step);
  for (int i = 0; i < steps; ++i) {
    const double u = from + i * step;
    const double density = factor + half * (u - std::exp(u));
    const double tail = std::erfc(deviations * std::exp(u / 2) / std::numbers::sqrt2) / 2;
    sum += std::exp(density) * tail * tail;
  }
  return 2 * sum * step;
}

double deviations_of(double chance, double freedom) {
  double low = 0, high = 1;
  while (both_beyond(high, freedom) > chance) low = high, high *= 2;
  while (high - low > 1e-4 * high) {
    const double middle = (low + high) / 2;
    (both_beyond(middle, freedom) > chance ? low : high) = middle;
  }
  return high;
}

double bernstein_distance(double chance, double spread, double reach, double samples) {
  const double exponent = -std::log(std::sqrt(chance / 2));  // of one picture
  const double linear = reach * exponent / (3 * samples);
  return linear + std::sqrt(linear * linear + 2 * exponent * spread * spread / samples);
}

}  // namespace lumaknot::validate
