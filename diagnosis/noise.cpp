#include "diagnosis/noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lumaknot::diagnosis {
namespace {

constexpr std::size_t kMinPixels = 300;
constexpr double kMinNoise = 1.5;        // times the noise that says nothing
constexpr double kMaxNeighbours = 0.06;  // correlation of neighbours
constexpr double kMaxMedian = 0.1;       // of the deviation
constexpr double kMinMedianSize =
    0.4;  // of the deviation; 0.67 if normal: few pixels alone are no noise
constexpr double kMaxWithGradient = 0.15;  // correlation of errors with the picture's gradient
constexpr int kBlock = 8;
constexpr double kMaxBlocks = 1.6;  // variance of blocks' means over that of noise

/// Sums for a correlation.
struct Correlation {
  double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;

  void add(double a, double b) { n += 1, x += a, y += b, xx += a * a, yy += b * b, xy += a * b; }
  double value() const {
    const double vx = xx - x * x / n, vy = yy - y * y / n;
    return n > 2 && vx > 0 && vy > 0 ? (xy - x * y / n) / std::sqrt(vx * vy) : 0;
  }
  /// Above `limit` by more than chance: of n independent pairs its standard error is 1 / sqrt(n).
  bool exceeds(double limit) const {
    constexpr double kErrors = 2;
    return std::abs(value()) > limit + kErrors / std::sqrt(std::max(n, 1.0));
  }
};

/// One channel of the difference.
class Residual {
 public:
  /// Without what noise of `margin` may have taken beyond the picture's limits.
  Residual(const Target& theirs, const Drawn& ours, std::size_t channel, double margin)
      : theirs_(theirs),
        ours_(ours),
        channel_(channel),
        margin_(theirs.facts.limited ? margin : -1e300) {}

  int columns() const { return theirs_.grid.columns; }
  int rows() const { return theirs_.grid.rows; }
  bool has(int x, int y) const {
    if (x < 0 || y < 0 || x >= columns() || y >= rows()) return false;
    const std::size_t i = index(x, y);
    if (ours_.coverage[i] < 1 || theirs_.coverage[i] < 1) return false;
    return our(x, y) >= margin_ && our(x, y) <= 1 - margin_;
  }
  double at(int x, int y) const {
    return components(theirs_.colors[index(x, y)])[channel_] - our(x, y);
  }
  double our(int x, int y) const { return components(ours_.colors[index(x, y)])[channel_]; }

 private:
  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(columns()) + std::size_t(x);
  }
  const Target& theirs_;
  const Drawn& ours_;
  std::size_t channel_;
  double margin_;
};

template <class F>
void each_pixel(const Residual& r, F act) {
  for (int y = 0; y < r.rows(); ++y) {
    for (int x = 0; x < r.columns(); ++x) {
      if (r.has(x, y)) act(x, y);
    }
  }
}

bool neighbours_correlate(const Residual& r) {
  Correlation across, down;
  each_pixel(r, [&](int x, int y) {
    if (r.has(x + 1, y)) across.add(r.at(x, y), r.at(x + 1, y));
    if (r.has(x, y + 1)) down.add(r.at(x, y), r.at(x, y + 1));
  });
  return across.exceeds(kMaxNeighbours) || down.exceeds(kMaxNeighbours);
}

bool follows_gradient(const Residual& r) {
  Correlation with;
  each_pixel(r, [&](int x, int y) {
    if (!r.has(x + 1, y) || !r.has(x - 1, y) || !r.has(x, y + 1) || !r.has(x, y - 1)) return;
    const double gradient =
        std::hypot(r.our(x + 1, y) - r.our(x - 1, y), r.our(x, y + 1) - r.our(x, y - 1));
    with.add(std::abs(r.at(x, y)), gradient);
  });
  return with.exceeds(kMaxWithGradient);
}

bool blocks_differ(const Residual& r, double variance) {
  double sum = 0, blocks = 0;
  for (int y = 0; y < r.rows(); y += kBlock) {
    for (int x = 0; x < r.columns(); x += kBlock) {
      double total = 0, count = 0;
      for (int i = 0; i < kBlock * kBlock; ++i) {
        const int px = x + i % kBlock, py = y + i / kBlock;
        if (r.has(px, py)) total += r.at(px, py), count += 1;
      }
      if (count > 0) sum += total * total / (count * variance), blocks += 1;
    }
  }
  return sum > kMaxBlocks * blocks;
}

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// How one channel's differences are spread.
struct Spread {
  std::size_t count = 0;
  double variance = 0, median = 0, median_size = 0;
  double deviation() const { return std::sqrt(variance); }
};

Spread spread_of(const Residual& r) {
  std::vector<double> values;
  double sum = 0;
  each_pixel(r, [&](int x, int y) {
    values.push_back(r.at(x, y));
    sum += values.back() * values.back();
  });
  if (values.empty()) return {};
  Spread spread{values.size(), sum / double(values.size()), median_of(values), 0};
  for (double& value : values) value = std::abs(value);
  spread.median_size = median_of(values);
  return spread;
}

/// The variance of one channel's noise.
std::optional<double> white_variance(const Target& theirs, const Drawn& ours, std::size_t channel) {
  constexpr double kMargin = 2;  // deviations: beyond, the mean is less than a hundredth off
  const double everywhere = spread_of({theirs, ours, channel, 0}).deviation();
  const Residual r(theirs, ours, channel, kMargin * everywhere);
  const Spread spread = spread_of(r);
  if (spread.count < kMinPixels || spread.deviation() < kMinNoise * theirs.facts.noise) return {};
  if (std::abs(spread.median) > kMaxMedian * spread.deviation()) return {};
  if (spread.median_size < kMinMedianSize * spread.deviation()) return {};
  if (neighbours_correlate(r) || follows_gradient(r)) return {};
  if (blocks_differ(r, spread.variance)) return {};
  return spread.variance;
}

}  // namespace

std::optional<double> white_noise(const Target& theirs, const Drawn& ours) {
  double sum = 0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::optional<double> variance = white_variance(theirs, ours, channel);
    if (!variance) return {};
    sum += *variance;
  }
  return std::sqrt(sum / 3);
}

}  // namespace lumaknot::diagnosis
