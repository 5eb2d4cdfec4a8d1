#include <algorithm>
#include <limits>

#include "study/chart.h"

namespace lumaknot {
namespace {

/// A point as the front sees it.
struct Candidate {
  std::size_t index;
  double error, time;
};

std::vector<Candidate> by_error(const Chart& chart, const Metric& metric, std::size_t truth) {
  std::vector<Candidate> all;
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const ChartPoint& point = chart.points[i];
    const auto time = frame_time(chart, point);
    if (!time || !point.errors[truth]) continue;
    all.push_back({i, (*point.errors[truth]).*metric.value, time->median});
  }
  std::ranges::stable_sort(all, {}, &Candidate::error);
  return all;
}

}  // namespace

std::optional<Spread> frame_time(const Chart& chart, const ChartPoint& point) {
  if (point.milliseconds.empty()) return std::nullopt;
  if (!point.method) return spread_of(point.milliseconds);
  const auto is_baseline = [&](const ChartPoint& p) { return p.name == chart.baseline; };
  const auto baseline = std::ranges::find_if(chart.points, is_baseline);
  if (baseline == chart.points.end() || baseline->milliseconds.empty()) return std::nullopt;
  const double milliseconds = median(baseline->milliseconds);
  const Spread ratio = spread_of(point.ratios);
  return Spread{ratio.median * milliseconds, ratio.least * milliseconds, ratio.most * milliseconds};
}

std::vector<std::size_t> pareto_front(const Chart& chart, const Metric& metric, std::size_t truth) {
  const std::vector<Candidate> all = by_error(chart, metric, truth);
  std::vector<std::size_t> front;
  double fastest = std::numeric_limits<double>::infinity();  // of all with smaller errors
  for (auto begin = all.begin(); begin != all.end();) {
    // Those whose errors are as good as the same: the best among the fastest of them.
    const double limit = begin->error * (1 + kSameError);
    const auto end = std::find_if(begin, all.end(), [&](auto& c) { return c.error > limit; });
    const double least = std::ranges::min_element(begin, end, {}, &Candidate::time)->time;
    if (least * (1 + kSameTime) < fastest) {
      const auto is_fast = [&](const Candidate& c) { return c.time <= least * (1 + kSameTime); };
      front.push_back(std::find_if(begin, end, is_fast)->index);
    }
    fastest = std::min(fastest, least);
    begin = end;
  }
  return front;
}

}  // namespace lumaknot
