#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/chart/points.h"
#include "study/measure/method_words.h"
#include "validate/report/page_kit.h"

namespace lumaknot::embedded {
std::string_view chart_template();
}  // namespace lumaknot::embedded

namespace lumaknot::chart {
namespace {

using Json = nlohmann::ordered_json;

/// JSON that is safe inside a script element: no "</script>" ends it.
std::string for_script(const std::string& json) {
  std::string text;
  for (const char c : json) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

std::string metrics_json() {
  Json json = Json::array();
  for (const Metric& metric : chart_metrics()) {
    json.push_back({{"name", metric.name}, {"about", metric.about}});
  }
  return json.dump();
}

}  // namespace

std::string chart_html(const Chart& chart, const std::string& scene) {
  validate::PageData page;
  page.set("scene", scene);
  page.set("points", std::to_string(chart.points.size()));
  page.set("width", std::to_string(chart.width));
  page.set("height", std::to_string(chart.height));
  page.set("truth", chart.truth);
  const auto baseline = std::ranges::find(chart.points, chart.baseline, &ChartPoint::name);
  page.set("baseline", baseline == chart.points.end() ? chart.baseline : words_of(*baseline));
  page.set("same_time", fmt::format("{:.0f}", 100 * kSameTime));
  page.set("same_error", fmt::format("{:.0f}", 100 * kSameError));
  page.set("missing", validate::page_list(chart.missing, [](const MissingPoint& m) {
             validate::PageData row;
             row.set("name", m.name);
             row.set("why", m.why);
             return row;
           }));
  page.set("legend", measure::method_legend_rows());
  page.set("chart", for_script(Json::parse(chart_json(chart)).dump()));
  page.set("metrics", for_script(metrics_json()));
  return validate::render_page(embedded::chart_template(), std::move(page));
}

}  // namespace lumaknot::chart
