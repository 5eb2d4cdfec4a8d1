#include "study/bench/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

namespace lumaknot::embedded {
std::string_view rates_template();
}  // namespace lumaknot::embedded

namespace lumaknot::bench {
namespace {

using Json = nlohmann::ordered_json;
namespace mustache = kainjow::mustache;

constexpr int kName = 46;  // columns of a renderer's name

double rate_of(const measure::Spread& milliseconds) { return 1000 / milliseconds.median; }

std::string samples_text(int samples) {
  return samples == 1 ? "none" : fmt::format("{}x", samples);
}

std::string threads_text(int threads) { return threads == 0 ? "-" : std::to_string(threads); }

/// At least three digits, and no meaningless decimals.
std::string rate_text(double rate) { return fmt::format("{:.{}f}", rate, rate < 100 ? 1 : 0); }

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

/// `text` in `columns`, its end cut off if it is longer.
std::string fitted(const std::string& text, std::size_t columns) {
  return text.size() <= columns ? text : text.substr(0, columns - 3) + "...";
}

std::string row_text(const RateRow& row) {
  const auto& ms = row.milliseconds;
  return fmt::format(
      "{:<{}}  {:>3}  {:>4}  {:>9}  {:>7}  {:>7}  {:>7}  {:>7}  {:>8.2f}  {:.2f}..{:.2f}\n",
      fitted(row.renderer, kName), kName, threads_text(row.threads), samples_text(row.samples),
      rate_text(rate_of(ms[0])), rate_text(rate_of(ms[1])), percent(row.costs[1]),
      rate_text(rate_of(ms[2])), percent(row.costs[2]), row.ratio, ms[0].min, ms[0].max);
}

/// The paper timed its listing, so its YIQ is in Table 1's column.
std::string paper_text(const PaperRow& row) {
  return fmt::format("{:<{}}  {:>3}  {:>4}  {:>9}  {:>7}  {:>7}  {:>7}  {:>7}\n",
                     fmt::format("paper, {} x {}: {}", row.side, row.side, row.machine), kName, "-",
                     samples_text(row.samples), rate_text(row.classical), "", "",
                     rate_text(row.yiq), percent(1 - row.yiq / row.classical));
}

/// The meaning of the columns, and how each kind of renderer draws.
std::string notes_text(const RateTable& table) {
  std::string text =
      "\nFrames a second, from the median frame; classical and YIQ drawn in turns, costs from "
      "pairs "
      "of neighbouring frames.\n"
      "YIQ: eq. 6-8, collapsed. Table 1: the paper's listing as written, which is what the paper "
      "timed.\n"
      "x ours: a classical frame's time over ours with as many threads, and as many samples or the "
      "next more. ms: the least and most of it.\n";
  std::vector<std::string> lines;
  for (const RateRow& row : table.rows) {
    lines.push_back(fmt::format("{}: {}.\n", row.renderer, row.how));
    if (std::ranges::count(lines, lines.back()) == 1) text += lines.back();
  }
  return text;
}

Json spread_json(const measure::Spread& ms) {
  return {{"frames_per_second", rate_of(ms)},
          {"milliseconds", {{"median", ms.median}, {"least", ms.min}, {"most", ms.max}}}};
}

Json row_json(const RateRow& row) {
  Json json{{"renderer", row.renderer},
            {"threads", row.threads},
            {"samples", row.samples},
            {"how", row.how}};
  for (std::size_t i = 0; i < kRateShots.size(); ++i) {
    Json& shot = json[std::string(kRateShots[i])] = spread_json(row.milliseconds[i]);
    if (i == 0) continue;
    shot["cost"] = row.costs[i];
    const Interval<double>& interval = row.cost_intervals[i];
    if (std::isfinite(interval.min)) shot["cost_interval"] = {interval.min, interval.max};
  }
  json["ratio_to_ours"] = row.ratio;
  return json;
}

/// A row of the chart: frames per second of classical, YIQ and Table 1; 0 if absent.
struct Bars {
  std::string name;
  std::array<double, kRateShots.size()> rates;
};

std::string samples_words(int samples) {
  return samples == 1 ? "1 sample" : fmt::format("{} samples", samples);
}

std::string threads_words(int threads) {
  if (threads == 0) return "";
  return threads == 1 ? ", 1 thread" : fmt::format(", {} threads", threads);
}

std::vector<Bars> all_bars(const RateTable& table) {
  std::vector<Bars> all;
  for (const RateRow& row : table.rows) {
    const auto& ms = row.milliseconds;
    all.push_back({fmt::format("{}{}, {}", fitted(row.renderer, kName), threads_words(row.threads),
                               samples_words(row.samples)),
                   {rate_of(ms[0]), rate_of(ms[1]), rate_of(ms[2])}});
  }
  for (const PaperRow& row : paper_rows()) {
    all.push_back({fmt::format("paper: {}, {} x {}, {}", row.machine, row.side, row.side,
                               samples_words(row.samples)),
                   {row.classical, 0, row.yiq}});
  }
  return all;
}

constexpr int kBarsLeft = 440, kBarsWidth = 460, kBarsTop = 78, kBar = 12, kGap = 10;
constexpr std::array<const char*, kRateShots.size()> kFills{"#8c96a3", "#d97b29", "#3f7f93"};

/// The bars of one row, from `y` downwards; `y` is moved below them.
mustache::data row_data(const Bars& bars, double max, int& y) {
  mustache::data list = mustache::data::type::list;
  const int top = y;
  for (std::size_t i = 0; i < bars.rates.size(); ++i) {
    if (bars.rates[i] == 0) continue;
    const double width = kBarsWidth * bars.rates[i] / max;
    mustache::data bar;
    bar.set("y", std::to_string(y));
    bar.set("text_y", std::to_string(y + kBar - 2));
    bar.set("width", fmt::format("{:.1f}", width));
    bar.set("end", fmt::format("{:.1f}", kBarsLeft + width + 6));
    bar.set("fill", kFills[i]);
    bar.set("rate", rate_text(bars.rates[i]));
    list.push_back(bar);
    y += kBar;
  }
  mustache::data row;
  row.set("name", bars.name);
  row.set("name_y", std::to_string((top + y) / 2 + 4));
  row.set("bars", list);
  y += kGap;
  return row;
}

mustache::data chart_data(const RateTable& table) {
  const std::vector<Bars> all = all_bars(table);
  double max = 0;
  for (const Bars& bars : all) max = std::max(max, std::ranges::max(bars.rates));
  mustache::data rows = mustache::data::type::list;
  int y = kBarsTop;
  for (const Bars& bars : all) rows.push_back(row_data(bars, max, y));
  mustache::data data;
  data.set("rows", rows);
  data.set("left", std::to_string(kBarsLeft));
  data.set("names_end", std::to_string(kBarsLeft - 10));
  data.set("bar", std::to_string(kBar));
  data.set("classical", kFills[0]);
  data.set("yiq", kFills[1]);
  data.set("table1", kFills[2]);
  data.set("height", std::to_string(y + kGap));
  data.set("image", fmt::format("{} x {}", table.width, table.height));
  return data;
}

}  // namespace

std::span<const PaperRow> paper_rows() {
  static constexpr PaperRow kRows[] = {{"Core 2 Quad, GeForce GTS 250", 720, 1, 1240, 1180},
                                       {"Core 2 Quad, GeForce GTS 250", 720, 8, 389, 385},
                                       {"Core 2 Duo, Radeon X1950 GT", 720, 1, 672, 453},
                                       {"Core 2 Duo, Radeon X1950 GT", 720, 6, 430, 341},
                                       {"Atom N280, Intel GMA 950", 512, 1, 44, 35}};
  return kRows;
}

std::string rates_text(const RateTable& table) {
  std::string text =
      fmt::format("{:<{}}  {:>3}  {:>4}  {:>9}  {:>7}  {:>7}  {:>7}  {:>7}  {:>8}  {}\n",
                  fmt::format("{} x {}", table.width, table.height), kName, "thr", "AA",
                  "classical", "YIQ", "costs", "Table 1", "costs", "x ours", "ms");
  for (const RateRow& row : table.rows) text += row_text(row);
  for (const PaperRow& row : paper_rows()) text += paper_text(row);
  for (const MissingRates& m : table.missing) {
    text += fmt::format("{:<{}}  missing: {}\n", m.renderer, kName, m.why);
  }
  return text + notes_text(table);
}

std::string rates_json(const RateTable& table) {
  Json json{{"width", table.width}, {"height", table.height}};
  json["rows"] = json["missing"] = json["paper"] = Json::array();
  for (const RateRow& row : table.rows) json["rows"].push_back(row_json(row));
  for (const MissingRates& m : table.missing) {
    json["missing"].push_back({{"renderer", m.renderer}, {"why", m.why}});
  }
  for (const PaperRow& row : paper_rows()) {
    json["paper"].push_back({{"machine", row.machine},
                             {"side", row.side},
                             {"samples", row.samples},
                             {"classical", row.classical},
                             {"yiq", row.yiq},
                             {"cost", 1 - row.yiq / row.classical}});
  }
  return json.dump(2) + "\n";
}

std::string rates_svg(const RateTable& table) {
  mustache::mustache chart{std::string(embedded::rates_template())};
  return chart.render(chart_data(table));
}

}  // namespace lumaknot::bench
