#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/fields.h"
#include "study/chart/checkpoint.h"
#include "study/measure/method_words.h"
#include "system/known.h"

namespace lumaknot::chart {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<ErrorLevel, 3> kColorLevels{
    {{"1/255", 1.0 / 255}, {"4/255", 4.0 / 255}, {"16/255", 16.0 / 255}}};
constexpr std::array<ErrorLevel, 3> kDeltaELevels{{{"0.5", 0.5}, {"1", 1}, {"2", 2}}};
constexpr std::array<ErrorLevel, 3> kFlipLevels{{{"0.01", 0.01}, {"0.02", 0.02}, {"0.05", 0.05}}};

constexpr Metric kMetrics[] = {
    {"rmse", "RMSE of all channels", &measure::Errors::rmse, kColorLevels},
    {"p99.9", "99.9 % of pixels' largest channels differ by less", &measure::Errors::p999,
     kColorLevels},
    {"max", "largest difference of a channel", &measure::Errors::max, kColorLevels},
    {"deltae", "mean CIEDE2000", &measure::Errors::delta_e, kDeltaELevels},
    {"deltae-p99.9", "99.9 % of pixels have a smaller CIEDE2000", &measure::Errors::delta_e_p999,
     kDeltaELevels},
    {"deltae-max", "largest CIEDE2000", &measure::Errors::delta_e_max, kDeltaELevels},
    {"flip", "mean FLIP at 67 pixels a degree", &measure::Errors::flip, kFlipLevels}};

Json method_json(const measure::Method& m) {
  return {{"segments", m.segments},  {"sides", m.sides},          {"rate", int(m.rate)},
          {"space", int(m.space)},   {"formula", int(m.formula)}, {"number", int(m.number)},
          {"filter", int(m.filter)}, {"samples", m.samples},      {"culls", m.culls}};
}

measure::Method method_from(const Json& json) {
  return {json.at("segments"),
          json.at("sides"),
          ShadingFrequency(json.at("rate").get<int>()),
          Space(json.at("space").get<int>()),
          measure::Formula(json.at("formula").get<int>()),
          measure::Number(json.at("number").get<int>()),
          Filter(json.at("filter").get<int>()),
          json.at("samples"),
          json.at("culls")};
}

Json errors_json(const measure::Errors& errors) {
  Json json;
  for (const Metric& metric : kMetrics) json[std::string(metric.name)] = errors.*metric.value;
  return json;
}

Json point_json(const Chart& chart, const ChartPoint& point) {
  Json json{{"name", point.name}, {"words", words_of(point)}};
  if (point.method) json["method"] = method_json(*point.method);
  json["space"] = kSpaceNames[std::size_t(point.space)];
  if (!point.how.empty()) json["how"] = point.how;
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    const std::optional<measure::Errors>& errors = point.errors[truth];
    if (errors) json["errors"][std::string(kTruthNames[truth])] = errors_json(*errors);
  }
  if (const auto time = frame_time(chart, point)) {
    json["milliseconds"] = {{"median", time->median}, {"least", time->min}, {"most", time->max}};
  }
  json["rounds"] = {{"ratios", point.ratios}, {"milliseconds", point.milliseconds}};
  return json;
}

ChartPoint point_from(const Json& json) {
  ChartPoint point;
  point.name = json.at("name");
  if (json.contains("method")) point.method = method_from(json["method"]);
  const auto space = std::ranges::find(kSpaceNames, json.at("space").get<std::string>());
  point.space = Space(space - kSpaceNames.begin());
  point.how = json.value("how", "");
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    const std::string name(kTruthNames[truth]);
    if (!json.contains("errors") || !json["errors"].contains(name)) continue;
    measure::Errors errors;
    for (const Metric& metric : kMetrics) {
      errors.*metric.value = json["errors"][name].at(std::string(metric.name));
    }
    point.errors[truth] = errors;
  }
  point.ratios = json.at("rounds").at("ratios").get<std::vector<double>>();
  point.milliseconds = json.at("rounds").at("milliseconds").get<std::vector<double>>();
  return point;
}

Json front_json(const Chart& chart, const Metric& metric, std::size_t truth, Space space) {
  Json names = Json::array();
  for (const std::size_t i : pareto_front(chart, metric, truth, space)) {
    names.push_back(chart.points[i].name);
  }
  return names;
}

Json advice_json(const Chart& chart, const Metric& metric, std::size_t truth, Space space) {
  Json list = Json::array();
  for (const Advice& a : advice(chart, metric, truth, space)) {
    list.push_back({{"error", a.level.name},
                    {"take", a.take ? Json(chart.points[*a.take].name) : Json(nullptr)},
                    {"nearest", chart.points[a.nearest].name},
                    {"sentence", advice_sentence(chart, metric, truth, a)}});
  }
  return list;
}

/// What `make` gives by truth, metric and space.
template <class Make>
Json by_space_json(const Chart& chart, const Make& make) {
  Json result;
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    for (const Metric& metric : kMetrics) {
      Json& all = result[std::string(kTruthNames[truth])][std::string(metric.name)];
      for (const Space space : spaces_in(chart)) {
        all[std::string(kSpaceNames[std::size_t(space)])] = make(chart, metric, truth, space);
      }
    }
  }
  return result;
}

/// `text` as a field of a table.
std::string quoted(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + "\"";
}

std::string csv_heads() {
  std::string errors, fronts;
  for (const std::string_view truth : kTruthNames) {
    for (const Metric& metric : kMetrics) {
      errors += fmt::format(",{} {}", truth, metric.name);
      fronts += fmt::format(",on {} {} front", truth, metric.name);
    }
  }
  return "name,space,milliseconds,least,most" + errors + fronts + "\n";
}

/// Whether each point is on its space's front.
using FrontMembers = std::vector<bool>;

/// By truth and metric, in the order of the heads.
std::vector<FrontMembers> front_members(const Chart& chart) {
  std::vector<FrontMembers> all;
  for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
    for (const Metric& metric : kMetrics) {
      FrontMembers& members = all.emplace_back(chart.points.size());
      for (const Space space : spaces_in(chart)) {
        for (const std::size_t i : pareto_front(chart, metric, truth, space)) members[i] = true;
      }
    }
  }
  return all;
}

}  // namespace

std::span<const Metric> chart_metrics() { return kMetrics; }

std::string words_of(const ChartPoint& point) {
  return point.method ? measure::method_words(*point.method) : point.name;
}

Json chart_values(const Chart& chart) {
  Json json{{"complete", chart.complete}, {"width", chart.width},       {"height", chart.height},
            {"truth", chart.truth},       {"baseline", chart.baseline}, {"same_time", kSameTime},
            {"same_error", kSameError}};
  if (chart.complete) {
    json["fronts"] = by_space_json(chart, front_json);
    json["advice"] = by_space_json(chart, advice_json);
  }
  json["points"] = json["missing"] = Json::array();
  for (const ChartPoint& point : chart.points) json["points"].push_back(point_json(chart, point));
  for (const MissingPoint& m : chart.missing) {
    json["missing"].push_back({{"name", m.name}, {"why", m.why}});
  }
  return json;
}

std::string advice_sentence(const Chart& chart, const Metric& metric, std::size_t truth,
                            const Advice& advice) {
  const ChartPoint& point = chart.points[advice.take.value_or(advice.nearest)];
  return fmt::format("for an error ({}) of at most {} {}{}: {} ms, {} {:.3g}", metric.name,
                     advice.level.name,
                     advice.take ? "take " : "no method is good enough; the nearest is ",
                     words_of(point), measure::shown_time(known(frame_time(chart, point)).median),
                     metric.name, known(error_from(point, metric, truth)));
}

std::string chart_json(const Chart& chart) {
  return measure::checkpoint_text(chart_keys(chart), chart_values(chart));
}

Chart chart_from(const Json& json) {
  Chart chart{json.at("scene"),
              json.at("program"),
              json.at("width"),
              json.at("height"),
              json.at("truth"),
              json.at("baseline"),
              {},
              {},
              json.at("complete")};
  for (const Json& point : json.at("points")) chart.points.push_back(point_from(point));
  for (const Json& m : json.at("missing")) chart.missing.push_back({m.at("name"), m.at("why")});
  return chart;
}

std::string chart_csv(const Chart& chart) {
  std::string text = csv_heads();
  const std::vector<FrontMembers> fronts = front_members(chart);
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const ChartPoint& point = chart.points[i];
    text += fmt::format("{},{}", quoted(point.name), kSpaceNames[std::size_t(point.space)]);
    const auto time = frame_time(chart, point);
    text += time ? fmt::format(",{},{},{}", time->median, time->min, time->max) : ",,,";
    for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
      for (const Metric& metric : kMetrics) {
        const std::optional<double> error = error_from(point, metric, truth);
        text += error ? fmt::format(",{}", *error) : ",";
      }
    }
    for (const FrontMembers& members : fronts) text += members[i] ? ",1" : ",0";
    text += "\n";
  }
  return text;
}

std::string chart_text(const Chart& chart, const Metric& metric) {
  constexpr int kNameWidth = 46;
  std::string text;
  for (const Space space : spaces_in(chart)) {
    for (std::size_t truth = 0; truth < kTruthNames.size(); ++truth) {
      text += fmt::format("{:<{}}  {:>9}  {:>8}  {}\n",
                          fmt::format("front in {}, from the {} truth",
                                      kSpaceNames[std::size_t(space)], kTruthNames[truth]),
                          kNameWidth, metric.name, "ms", "least..most");
      for (const std::size_t i : pareto_front(chart, metric, truth, space)) {
        const ChartPoint& point = chart.points[i];
        const measure::Spread time = known(frame_time(chart, point));
        text +=
            fmt::format("  {:<{}}  {:>9.3g}  {:>8}  {}..{}\n", point.name, kNameWidth - 2,
                        known(error_from(point, metric, truth)), measure::shown_time(time.median),
                        measure::shown_time(time.min), measure::shown_time(time.max));
      }
      for (const Advice& a : advice(chart, metric, truth, space)) {
        text += fmt::format("  {}\n", advice_sentence(chart, metric, truth, a));
      }
    }
  }
  for (const MissingPoint& m : chart.missing) {
    text += fmt::format("{}  missing: {}\n", m.name, m.why);
  }
  return text + fmt::format(
                    "Errors from the exact picture in a method's own space: {}.\nTimes "
                    "are of one thread (Cycles, Eevee and POV-Ray: all cores); those within {:.0f} "
                    "% count as "
                    "equal, errors within {:.0f} %.",
                    chart.truth, 100 * kSameTime, 100 * kSameError);
}

}  // namespace lumaknot::chart
