#include "study/stability/atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/measure/gnuplot.h"
#include "study/stability/sketches.h"

namespace lumaknot::stability {
namespace {

std::vector<Measured> measure(const Measurement& measure, const std::vector<double>& values,
                              const std::function<void()>& tick) {
  std::vector<Measured> result;
  for (const double x : values) {
    tick();
    result.push_back({x, measure(x)});
  }
  return result;
}

/// The worst of the errors; not a number if there are none, or one is not a number.
double worst(const std::vector<Measured>& all) {
  if (all.empty()) return std::numeric_limits<double>::quiet_NaN();
  double result = -std::numeric_limits<double>::infinity();
  for (const Measured& m : all) {
    if (std::isnan(m.error)) return m.error;
    result = std::max(result, m.error);
  }
  return result;
}

void add_pictures(const Region& region, const AtlasOptions& options, Entry& entry) {
  const double holding = region.shown_holds.value_or(region.sweep.from);
  const double failing = region.shown_fails.value_or(region.sweep.to);
  const auto value = [](double x) { return fmt::format("{:.4g}", x); };
  const auto add = [&](const char* name, std::string caption, const Image& image) {
    entry.pictures.push_back({std::move(caption), fmt::format("{}.png", name), sketch_png(image)});
  };
  entry.pictures.push_back({"", "chart.svg", sweep_chart(region, entry)});
  if (!region.sketch) return;
  add("holds", "holds, " + value(holding), region.sketch(holding, options.side));
  const Image fails = region.sketch(failing, options.side);
  add("fails", "fails, " + value(failing), fails);
  if (!region.guarded_sketch) return;
  const Image remedy = region.guarded_sketch(failing, options.side);
  add("remedy",
      "the remedy, " + (region.guarded_shows ? region.guarded_shows(failing) : value(failing)),
      remedy);
  if (const auto difference = difference_if_alike(fails, remedy)) {
    add("difference", fmt::format("fails less the remedy, times {}", difference->gain),
        difference->image);
  }
}

void add_quantities(const Region& region, Entry& entry) {
  const double holding = region.shown_holds.value_or(region.sweep.from);
  const double failing = region.shown_fails.value_or(region.sweep.to);
  const auto& [holds, fails] = entry.boundary;
  for (const auto& [name, measure] : region.also) {
    entry.also.push_back(
        {name, measure(holding), measure(holds.x), measure(fails.x), measure(failing)});
  }
}

}  // namespace

std::vector<SweepInterval> holding_again(const Entry& entry) {
  std::vector<SweepInterval> all = stretches(entry.sweep, entry.limit, true);
  if (!all.empty()) all.erase(all.begin());  // a sweep begins where the method holds
  return all;
}

Entry examine(const Region& region, const AtlasOptions& options,
              const std::function<void(double)>& tick) {
  const std::vector<double> values = swept_values(region.sweep, options.steps);
  int done = 0;
  const double all = double(values.size()) * (region.guarded ? 2 : 1) * 1.3;
  const auto count = [&] { tick(std::min(done++ / all, 1.0)); };
  Entry entry{region.name,
              region.group,
              region.method,
              region.reason,
              region.remedy,
              region.sweep.parameter,
              region.measured,
              region.limit,
              {},
              0,
              {},
              {},
              {},
              {}};
  entry.sweep = measure(region.error, values, count);
  if (region.guarded) entry.guarded = measure(region.guarded, values, count);
  entry.guarded_worst = worst(entry.guarded);
  entry.boundary = find_boundary(region, entry.sweep);
  if (!options.pictures) return entry;
  add_pictures(region, options, entry);
  add_quantities(region, entry);
  return entry;
}

namespace {

/// `text` in gnuplot's quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

/// Whether an axis from `min` to `max` is better logarithmic.
bool spans_decades(double min, double max) { return min > 0 && max / min > 50; }

std::string data_block(const char* name, const std::vector<Measured>& all, bool logarithmic) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (const Measured& m : all) {
    if (std::isfinite(m.error)) {
      text +=
          fmt::format("{:.9g} {:.9g}\n", m.x, logarithmic ? std::max(m.error, 1e-300) : m.error);
    } else {
      text += fmt::format("{:.9g} NaN\n", m.x);
    }
  }
  return text + "EOD\n";
}

/// A shade on each interval that fails. They have borders, so that a single value is a line.
std::string shades(const Entry& entry) {
  std::string text;
  std::vector<SweepInterval> failing = stretches(entry.sweep, entry.limit, false);
  if (!failing.empty()) failing.front().from = entry.boundary.fails.x;
  for (const SweepInterval& s : failing) {
    text += fmt::format(
        "set object rectangle from {:.9g}, graph 0 to {:.9g}, graph 1 behind fillcolor rgb "
        "'#fbe3df' fillstyle solid border linecolor rgb '#fbe3df'\n",
        s.from, s.to);
  }
  return text;
}

}  // namespace

std::string sweep_chart(const Region& region, const Entry& entry) {
  double min = entry.limit, max = entry.limit;
  for (const std::vector<Measured>* list : {&entry.sweep, &entry.guarded}) {
    for (const Measured& m : *list) {
      if (!std::isfinite(m.error)) continue;
      if (m.error > 0) min = std::min(min, m.error);
      max = std::max(max, m.error);
    }
  }
  const bool logarithmic = spans_decades(min, max);
  min = std::max({min, max * 1e-12, entry.limit * 1e-6});
  std::string script = data_block("method", entry.sweep, logarithmic) +
                       data_block("remedy", entry.guarded, logarithmic);
  script += fmt::format(
      "set xlabel {}\nset title {} font ',10'\nset key bmargin center horizontal\nset grid\n",
      quoted(region.sweep.parameter), quoted(region.measured));
  if (region.sweep.logarithmic) script += "set logscale x\nset format x '%g'\n";
  if (logarithmic) script += "set logscale y\nset format y '%.0e'\n";
  const double from = region.sweep.from, to = region.sweep.to;
  script += fmt::format("set xrange [{:.9g}:{:.9g}]\n", from, to);
  script += logarithmic ? fmt::format("set yrange [{:.3g}:{:.3g}]\n", min / 2, max * 3)
                        : fmt::format("set yrange [{}:{:.6g}]\n", "0", max * 1.15);
  script += shades(entry);
  script += fmt::format(
      "plot {:.9g} with lines linecolor rgb '#888888' dashtype 2 title 'limit', $method with "
      "linespoints linecolor rgb '#c0392b' pointtype 7 pointsize 0.4 title 'method'{}",
      entry.limit,
      entry.guarded.empty() ? ""
                            : ", $remedy with linespoints linecolor rgb '#1a7f37' pointtype 7 "
                              "pointsize 0.4 title 'remedy'");
  return measure::draw_chart(script, measure::ChartFormat::kSvg, 560, 340);
}

}  // namespace lumaknot::stability
