#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include "study/bench/scaling.h"

namespace lumaknot::embedded {
std::string_view scaling_template();
}  // namespace lumaknot::embedded

namespace lumaknot::bench {
namespace {

using Json = nlohmann::ordered_json;
namespace mustache = kainjow::mustache;

/// The positions of powers of ten in the chart.
constexpr double kAxesLeft = 60, kAxesRight = 710, kAxesTop = 50, kAxesBottom = 480;
constexpr std::array<const char*, 3> kColors{"#d97b29", "#3f7f93", "#7a5195"};

/// The chart's decades, across and upwards.
struct ScalingAxes {
  double decades_x = 1, decades_y = 1;

  double x(double ratio) const {
    return kAxesLeft + (kAxesRight - kAxesLeft) * std::log10(ratio) / decades_x;
  }
  double y(double ratio) const {
    return kAxesBottom - (kAxesBottom - kAxesTop) * std::log10(ratio) / decades_y;
  }
};

double work_ratio(const Scaling& g, std::size_t i) { return g.steps[i].work / g.steps[0].work; }

double time_ratio(const Scaling& g, std::size_t i) {
  return g.steps[i].milliseconds.median / g.steps[0].milliseconds.median;
}

ScalingAxes axes_of(const std::vector<Scaling>& all) {
  ScalingAxes axes;
  for (const Scaling& g : all) {
    for (std::size_t i = 0; i < g.steps.size(); ++i) {
      axes.decades_x = std::max(axes.decades_x, std::ceil(std::log10(work_ratio(g, i))));
      axes.decades_y = std::max(axes.decades_y, std::ceil(std::log10(time_ratio(g, i))));
    }
  }
  return axes;
}

std::string number(double x) { return fmt::format("{:.1f}", x); }

mustache::data line_data(double x1, double y1, double x2, double y2) {
  mustache::data line;
  line.set("x1", number(x1));
  line.set("y1", number(y1));
  line.set("x2", number(x2));
  line.set("y2", number(y2));
  return line;
}

mustache::data label_data(double x, double y, const char* anchor, int decade) {
  mustache::data label;
  label.set("x", number(x));
  label.set("y", number(y));
  label.set("anchor", anchor);
  label.set("text", fmt::format("{:g} x", std::pow(10, decade)));
  return label;
}

void add_grid(mustache::data& chart, const ScalingAxes& axes) {
  mustache::data lines = mustache::data::type::list, labels = mustache::data::type::list;
  for (int decade = 0; decade <= axes.decades_x; ++decade) {
    const double x = axes.x(std::pow(10, decade));
    lines.push_back(line_data(x, kAxesTop, x, kAxesBottom));
    labels.push_back(label_data(x, kAxesBottom + 20, "middle", decade));
  }
  for (int decade = 0; decade <= axes.decades_y; ++decade) {
    const double y = axes.y(std::pow(10, decade));
    lines.push_back(line_data(kAxesLeft, y, kAxesRight, y));
    labels.push_back(label_data(kAxesLeft - 8, y + 4, "end", decade));
  }
  chart.set("lines", lines);
  chart.set("labels", labels);
}

mustache::data scaling_data(const Scaling& g, const ScalingAxes& axes, std::size_t index) {
  mustache::data data, dots = mustache::data::type::list;
  std::string points;
  for (std::size_t i = 0; i < g.steps.size(); ++i) {
    const std::string x = number(axes.x(work_ratio(g, i))), y = number(axes.y(time_ratio(g, i)));
    points += fmt::format("{},{} ", x, y);
    mustache::data dot;
    dot.set("x", x);
    dot.set("y", y);
    dot.set("title", fmt::format("{}: {:.2f} ms", g.steps[i].name, g.steps[i].milliseconds.median));
    dots.push_back(dot);
  }
  data.set("points", points);
  data.set("dots", dots);
  data.set("name", g.name);
  data.set("color", kColors[index % kColors.size()]);
  data.set("key_y", number(kAxesTop + 10 + 20 * double(index)));
  data.set("key_text_y", number(kAxesTop + 21 + 20 * double(index)));
  return data;
}

}  // namespace

std::string scaling_text(const std::vector<Scaling>& all) {
  std::string text;
  for (const Scaling& scaling : all) {
    text += fmt::format("{:<24}  {:>10}  {:>6}\n", scaling.name, "ms", "slope");
    for (std::size_t i = 0; i < scaling.steps.size(); ++i) {
      const ScalingStep& step = scaling.steps[i];
      text += fmt::format("{:<24}  {:>10.2f}  {:>6}\n", step.name, step.milliseconds.median,
                          i > 0 ? fmt::format("{:.2f}", slope_of(scaling, i)) : "");
    }
  }
  return text + "Slope: of the time over the work, both logarithmic; 1 is linear.\n";
}

std::string scaling_json(const std::vector<Scaling>& all) {
  Json json;
  for (const Scaling& scaling : all) {
    for (std::size_t i = 0; i < scaling.steps.size(); ++i) {
      const ScalingStep& step = scaling.steps[i];
      const measure::Spread& ms = step.milliseconds;
      Json entry{{"name", step.name},
                 {"work", step.work},
                 {"milliseconds", {{"median", ms.median}, {"least", ms.min}, {"most", ms.max}}}};
      if (i > 0) entry["slope"] = slope_of(scaling, i);
      json[scaling.name].push_back(entry);
    }
  }
  return json.dump(2) + "\n";
}

std::string scaling_svg(const std::vector<Scaling>& all) {
  const ScalingAxes axes = axes_of(all);
  mustache::data chart, scalings = mustache::data::type::list;
  add_grid(chart, axes);
  for (std::size_t i = 0; i < all.size(); ++i) scalings.push_back(scaling_data(all[i], axes, i));
  chart.set("growths", scalings);
  const double end = std::pow(10, std::min(axes.decades_x, axes.decades_y));
  chart.set("linear", fmt::format("{},{} {},{}", number(axes.x(1)), number(axes.y(1)),
                                  number(axes.x(end)), number(axes.y(end))));
  chart.set("linear_text_y", number(kAxesTop + 21 + 20 * double(all.size())));
  mustache::mustache picture{std::string(embedded::scaling_template())};
  return picture.render(chart);
}

}  // namespace lumaknot::bench
