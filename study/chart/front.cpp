#include <algorithm>
#include <cmath>
#include <limits>

#include "study/chart/points.h"

namespace lumaknot::chart {
namespace {

/// A point as the front sees it.
struct Candidate {
  std::size_t index;
  double error, time;
};

std::vector<Candidate> by_error(const Chart& chart, const Metric& metric, std::size_t truth,
                                Space space) {
  std::vector<Candidate> all;
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const ChartPoint& point = chart.points[i];
    const std::optional<measure::Spread> time = frame_time(chart, point);
    const std::optional<double> error = error_from(point, metric, truth);
    if (!time || !error || point.space != space) continue;
    all.push_back({i, *error, time->median});
  }
  std::ranges::stable_sort(all, {}, &Candidate::error);
  return all;
}

/// The first point of the chart among those as good as the fastest.
std::size_t first_of(std::span<const Candidate> equals, double min) {
  std::size_t first = std::numeric_limits<std::size_t>::max();
  for (const Candidate& c : equals) {
    if (c.time <= min * (1 + kSameTime)) first = std::min(first, c.index);
  }
  return first;
}

/// By truth and space.
using Fronts = std::vector<std::vector<std::size_t>>;

Fronts fronts_of(const Chart& chart, const Metric& metric) {
  Fronts fronts;
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    for (const Space space : spaces_in(chart)) {
      fronts.push_back(pareto_front(chart, metric, truth, space));
    }
  }
  return fronts;
}

/// The share by which the median of `ratios` may be off: three standard errors, from the median
/// distance to the median (a normal distribution's is 0.6745 sigma, and its median's standard error
/// 1.2533 sigma / sqrt(n)).
double open_share(const std::vector<double>& ratios) {
  const double middle = measure::median(ratios);
  std::vector<double> distances;
  distances.reserve(ratios.size());
  for (const double ratio : ratios) distances.push_back(std::abs(ratio / middle - 1));
  const double sigma = measure::median(distances) / 0.6745;
  return 3 * 1.2533 * sigma / std::sqrt(double(ratios.size()));
}

}  // namespace

std::optional<double> error_from(const ChartPoint& point, const Metric& metric, std::size_t truth) {
  const std::optional<measure::Errors>& errors = point.errors[truth];
  if (!errors) return {};
  return (*errors).*metric.value;
}

std::optional<measure::Spread> frame_time(const Chart& chart, const ChartPoint& point) {
  if (point.milliseconds.empty()) return std::nullopt;
  if (!point.method) return measure::spread_of(point.milliseconds);
  const auto is_baseline = [&](const ChartPoint& p) { return p.name == chart.baseline; };
  const auto baseline = std::ranges::find_if(chart.points, is_baseline);
  if (baseline == chart.points.end() || baseline->milliseconds.empty()) return std::nullopt;
  const double milliseconds = measure::median(baseline->milliseconds);
  const measure::Spread ratio = measure::spread_of(point.ratios);
  return measure::Spread{ratio.median * milliseconds, ratio.min * milliseconds,
                         ratio.max * milliseconds};
}

std::vector<std::size_t> pareto_front(const Chart& chart, const Metric& metric, std::size_t truth,
                                      Space space) {
  const std::vector<Candidate> all = by_error(chart, metric, truth, space);
  std::vector<std::size_t> front;
  double fastest = std::numeric_limits<double>::infinity();  // of all with smaller errors
  for (auto begin = all.begin(); begin != all.end();) {
    const double limit = begin->error * (1 + kSameError);
    const auto end =
        std::find_if(begin, all.end(), [&](const Candidate& c) { return c.error > limit; });
    const std::span<const Candidate> equals(begin, end);
    const double min = std::ranges::min_element(equals, {}, &Candidate::time)->time;
    if (min * (1 + kSameTime) < fastest) front.push_back(first_of(equals, min));
    fastest = std::min(fastest, min);
    begin = end;
  }
  return front;
}

std::vector<Advice> advice(const Chart& chart, const Metric& metric, std::size_t truth,
                           Space space) {
  const std::vector<Candidate> all = by_error(chart, metric, truth, space);
  std::vector<Advice> result;
  if (all.empty()) return result;
  for (const ErrorLevel& level : metric.levels) {
    const auto end = std::ranges::upper_bound(all, level.value, {}, &Candidate::error);
    const std::span<const Candidate> within(all.begin(), end);
    Advice& found = result.emplace_back(Advice{level, {}, all.front().index});
    if (within.empty()) continue;
    found.take = first_of(within, std::ranges::min_element(within, {}, &Candidate::time)->time);
  }
  return result;
}

std::vector<Space> spaces_in(const Chart& chart) {
  std::vector<Space> spaces;
  for (const ChartPoint& point : chart.points) {
    if (std::ranges::count(spaces, point.space) == 0) spaces.push_back(point.space);
  }
  return spaces;
}

std::vector<std::size_t> contested_points(const Chart& chart, const Metric& metric) {
  const Fronts found = fronts_of(chart, metric);
  Chart trial = chart;
  std::vector<std::size_t> contested;
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const std::vector<double>& ratios = chart.points[i].ratios;
    if (ratios.empty()) continue;
    const double open = open_share(ratios);
    for (const double factor : {1 + open, 1 / (1 + open)}) {
      for (std::size_t k = 0; k < ratios.size(); ++k) {
        trial.points[i].ratios[k] = ratios[k] * factor;
      }
      const bool differs = fronts_of(trial, metric) != found;
      if (differs && (contested.empty() || contested.back() != i)) contested.push_back(i);
    }
    trial.points[i].ratios = ratios;
  }
  return contested;
}

}  // namespace lumaknot::chart
