#include "validate/compare/noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "validate/compare/blocks.h"
#include "validate/compare/one_sided.h"
#include "validate/compare/quantile.h"

namespace lumaknot::validate {
namespace {

constexpr int kScaleStep = 4;           // between the sides of blocks
constexpr std::size_t kStratum = 512;   // pixels whose variances are pooled
constexpr long long kCalibrated = 64;   // blocks that tell how their variances add up
constexpr double kRoundingBias = 1e-5;  // bias that float32 causes: 6e-6 on average in Figure 2
constexpr double kOwnErrors = 4;        // standard deviations of our own sampling that are granted
constexpr double kFilterTail = 1e-3;    // share of a filter that need not be as described
constexpr double kSurely = 1.955;       // two normal variables are above minus this: 95 %

/// Sums over the pixels of a block, in one channel.
struct NoiseCell {
  double pixels = 0;
  double first = 0, second = 0;  ///< of the pictures, less their expectation
  double own = 0;                ///< half the difference of our two estimates
  double variance = 0, own_variance = 0;
  double spread = 0, reach = 0;  ///< of a single pixel's samples

  void add(const NoiseCell& cell) {
    pixels += cell.pixels;
    first += cell.first;
    second += cell.second;
    own += cell.own;
    variance += cell.variance;
    own_variance += cell.own_variance;
  }
  bool is_noisy() const { return variance > 0; }
};

/// Moments of the differences of two pictures, in units of their deviation.
struct Moments {
  double count = 0, square = 0, fourth = 0;

  void add(double difference) {
    ++count;
    square += difference * difference;
    fourth += std::pow(difference, 4);
  }
  double mean_square() const { return square / count; }

  /// Those of the t distribution with their kurtosis, to which comes that of a variance pooled from
  /// `count` values.
  double freedom() const {
    const double kurtosis = square > 0 ? count * fourth / (square * square) : 3;
    return 4 + 6 / (std::max(0.0, kurtosis - 3) + 6 / std::max(count - 4, 1.0));
  }
};

/// The largest value of the pixel and of its neighbours.
double largest_about(const Grid<Channels>& grid, int x, int y, std::size_t channel) {
  double largest = 0;
  for (int v = std::max(0, y - 1); v <= std::min(grid.height - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(grid.width - 1, x + 1); ++u) {
      largest = std::max(largest, grid.at(u, v)[channel]);
    }
  }
  return largest;
}

Grid<NoiseCell> pixel_cells(const NoisyPair& pair, std::size_t channel) {
  Grid<NoiseCell> cells(pair.first.width, pair.first.height);
  for (int y = 0; y < cells.height; ++y) {
    for (int x = 0; x < cells.width; ++x) {
      const double a = pair.expected.halves[0].at(x, y)[channel];
      const double b = pair.expected.halves[1].at(x, y)[channel];
      NoiseCell& cell = cells.at(x, y);
      cell.pixels = 1;
      cell.first = channel_of(pair.first.at(x, y), channel) - (a + b) / 2;
      cell.second = channel_of(pair.second.at(x, y), channel) - (a + b) / 2;
      cell.own = (a - b) / 2;
      cell.reach = largest_about(pair.expected.reach, x, y, channel);
      cell.spread =
          std::hypot(pair.expected.spread.at(x, y)[channel], std::sqrt(kFilterTail) * cell.reach);
    }
  }
  return cells;
}

/// Gives pixels their variances: each a share of what independent samples would have, which is the
/// same for 512 pixels of like spread.
void pool_variances(int samples, Grid<NoiseCell>& cells) {
  std::vector<NoiseCell*> order;
  for (NoiseCell& cell : cells.pixels) {
    if (cell.spread > 0) order.push_back(&cell);
  }
  std::ranges::stable_sort(order, {}, &NoiseCell::spread);
  const std::size_t strata = std::max<std::size_t>(1, order.size() / kStratum);
  for (std::size_t s = 0; s < strata; ++s) {
    const auto begin = order.begin() + std::ptrdiff_t(s * order.size() / strata);
    const auto end = order.begin() + std::ptrdiff_t((s + 1) * order.size() / strata);
    double measured = 0, independent = 0, own = 0;
    for (const NoiseCell* cell : std::ranges::subrange(begin, end)) {
      measured += std::pow(cell->first - cell->second, 2) / 2;
      independent += cell->spread * cell->spread / samples;
      own += cell->own * cell->own;
    }
    const double share = std::max(measured / independent, 1.0 / samples);
    for (NoiseCell* cell : std::ranges::subrange(begin, end)) {
      cell->variance = share * cell->spread * cell->spread / samples;
      cell->own_variance = own / double(end - begin);
    }
  }
}

/// One channel of a pair.
class ChannelTest {
 public:
  /// `error` of each scale.
  ChannelTest(const NoisyPair& pair, std::size_t channel, double error)
      : channel_(channel),
        samples_(pair.samples),
        error_(error),
        cells_(pixel_cells(pair, channel)) {
    pool_variances(samples_, cells_);
  }

  /// Of the blocks of a scale; called for each in order.
  void test(NoiseScale& scale, Grid<PixelMark>& marks) {
    if (scale.block > 1) merge();
    calibrate();
    const double chance = error_ / double(cells_.pixels.size());
    const double common = scale.block > 1 ? deviations_of(chance, freedom_) : 0;
    std::vector<double> seen;
    double variance = 0;
    for (int y = 0; y < cells_.height; ++y) {
      for (int x = 0; x < cells_.width; ++x) {
        const NoiseCell& cell = cells_.at(x, y);
        NoiseFinding finding = finding_of(cell, {x * scale.block, y * scale.block});
        finding.admitted =
            granted(cell) + (scale.block > 1
                                 ? common * finding.deviation
                                 : bernstein_distance(chance, cell.spread, cell.reach, samples_));
        count(finding, scale);
        if (finding.exceeds() && cells_.pixels.size() > 1) mark(finding, scale.block, marks);
        if (!cell.is_noisy()) continue;
        variance += finding.deviation * finding.deviation;
        seen.push_back(finding.admitted + kSurely * finding.deviation);
      }
    }
    if (seen.empty() || channel_ == kCoverageChannel) return;
    scale.noise = std::max(scale.noise, std::sqrt(variance / double(seen.size())));
    scale.seen = std::max(scale.seen, quantile(std::move(seen), 0.5));
  }

 private:
  void merge() {
    cells_ = per_block<NoiseCell>(cells_, kScaleStep, [](const auto& each) {
      NoiseCell sum;
      each([&](const NoiseCell& cell) { sum.add(cell); });
      return sum;
    });
  }

  /// How the variances of these blocks differ from the sums of their pixels', and how heavy their
  /// tails are; of too few blocks, as of the smaller ones.
  void calibrate() {
    Moments theirs, own;
    for (const NoiseCell& cell : cells_.pixels) {
      if (!cell.is_noisy()) continue;
      theirs.add((cell.first - cell.second) / std::sqrt(2 * cell.variance));
      if (cell.own_variance > 0) own.add(cell.own / std::sqrt(cell.own_variance));
    }
    if (theirs.count < kCalibrated) return;
    inflation_ = std::max(1.0, theirs.mean_square());
    freedom_ = theirs.freedom();
    if (own.count > 0) own_inflation_ = std::max(1.0, own.mean_square());
  }

  /// What rounding and our own sampling may add to a block's mean.
  double granted(const NoiseCell& cell) const {
    return kRoundingBias + kOwnErrors * std::sqrt(own_inflation_ * cell.own_variance) / cell.pixels;
  }

  /// Without what is admitted.
  NoiseFinding finding_of(const NoiseCell& cell, PixelPlace place) const {
    NoiseFinding finding{place, channel_};
    finding.bias = (cell.first + cell.second) / (2 * cell.pixels);
    finding.deviation = std::sqrt(inflation_ * cell.variance) / cell.pixels;
    if ((cell.first > 0) == (cell.second > 0)) {
      finding.distance = std::min(std::abs(cell.first), std::abs(cell.second)) / cell.pixels;
    }
    return finding;
  }

  static void count(const NoiseFinding& finding, NoiseScale& scale) {
    ++scale.tests;
    if (finding.exceeds()) {
      ++(finding.channel == kCoverageChannel ? scale.coverage_exceeded : scale.exceeded);
    }
    if (scale.worst.admitted == 0 || finding.share() > scale.worst.share()) scale.worst = finding;
  }

  static void mark(const NoiseFinding& finding, int block, Grid<PixelMark>& marks) {
    for (int y = finding.place.y; y < std::min(marks.height, finding.place.y + block); ++y) {
      for (int x = finding.place.x; x < std::min(marks.width, finding.place.x + block); ++x) {
        marks.at(x, y) = 1 + PixelMark(PixelClass::kUnexplained);
      }
    }
  }

  std::size_t channel_;
  int samples_;
  double error_;
  Grid<NoiseCell> cells_;
  double inflation_ = 1, own_inflation_ = 1, freedom_ = 8;
};

}  // namespace

double channel_of(const RgbaPixel& pixel, std::size_t channel) {
  const std::array<float, 4> values{pixel.color.r, pixel.color.g, pixel.color.b, pixel.coverage};
  return values[channel];
}

long long NoiseTest::exceeded(bool in_coverage) const {
  long long sum = 0;
  for (const NoiseScale& scale : scales) {
    sum += in_coverage ? scale.coverage_exceeded : scale.exceeded;
  }
  return sum;
}

NoiseTest test_noise(const NoisyPair& pair, double family_error) {
  NoiseTest test{family_error, {}, {pair.first.width, pair.first.height}};
  const int size = std::max(pair.first.width, pair.first.height);
  NoiseScale scale;
  for (; scale.block < size; scale.block *= kScaleStep) test.scales.push_back(scale);
  test.scales.push_back(scale);
  const double error = family_error / double(kChannelNames.size() * test.scales.size());
  for (std::size_t channel = 0; channel < kChannelNames.size(); ++channel) {
    ChannelTest channel_test(pair, channel, error);
    for (NoiseScale& each : test.scales) channel_test.test(each, test.marks);
  }
  return test;
}

}  // namespace lumaknot::validate
