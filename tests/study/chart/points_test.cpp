// Fronts of times that are given, and what is written of them. No time is measured here.
#include "study/chart/points.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "study/chart/checkpoint.h"

namespace lumaknot::chart {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Metric& rmse() { return chart_metrics().front(); }

/// A method of one sample with that error, whose frames take so many times the baseline's.
ChartPoint point(std::string name, double error, std::vector<double> ratios,
                 Space space = Space::kRgb) {
  ChartPoint p{std::move(name), measure::Method{.space = space}, space, {}, {}, {}, {}};
  measure::Errors errors;
  errors.rmse = error;
  p.errors = {errors, errors};
  p.ratios = std::move(ratios);
  p.milliseconds = std::vector<double>(p.ratios.size(), 4.0);
  return p;
}

Chart chart_of(std::vector<ChartPoint> points) {
  Chart chart;
  chart.width = 64, chart.height = 48;
  chart.scene_key = "s", chart.program_key = "p";
  chart.truth = "the truth", chart.baseline = points.front().name;
  chart.points = std::move(points);
  chart.complete = true;
  return chart;
}

std::vector<std::string> front(const Chart& chart, Space space = Space::kRgb) {
  std::vector<std::string> names;
  for (const std::size_t i : pareto_front(chart, rmse(), 0, space)) {
    names.push_back(chart.points[i].name);
  }
  return names;
}

TEST(Front, holds_what_nothing_better_is_as_fast_as) {
  EXPECT_THAT(front(chart_of({point("base", 0.02, {1}), point("slow", 0.01, {3}),
                              point("bad", 0.03, {2}), point("fast", 0.05, {0.5})})),
              ElementsAre("slow", "base", "fast"));
}

TEST(Front, times_within_the_margin_are_equal_so_the_better_one_stays) {
  EXPECT_THAT(front(chart_of({point("base", 0.02, {1}), point("hardly faster", 0.03, {0.96})})),
              ElementsAre("base"));
  EXPECT_THAT(front(chart_of({point("base", 0.02, {1}), point("faster", 0.03, {0.94})})),
              ElementsAre("base", "faster"));
}

TEST(Front, of_equal_errors_the_fastest_stays_and_of_equal_times_too_the_first) {
  EXPECT_THAT(front(chart_of({point("first", 0.0201, {1}), point("slow", 0.02, {9}),
                              point("same", 0.02, {0.97})})),
              ElementsAre("first"));
}

TEST(Front, hardly_faster_ones_do_not_add_up) {
  // Each is 4 % faster than the one before: the third is faster than the first by more than 5 %.
  EXPECT_THAT(front(chart_of(
                  {point("base", 0.02, {1}), point("b", 0.03, {0.96}), point("c", 0.04, {0.92})})),
              ElementsAre("base"));
}

TEST(Front, spaces_do_not_compete) {
  const Chart chart = chart_of({point("base", 0.02, {1}), point("yiq", 0.03, {1}, Space::kYiq)});
  EXPECT_THAT(front(chart), ElementsAre("base"));
  EXPECT_THAT(front(chart, Space::kYiq), ElementsAre("yiq"));
}

TEST(Front, a_point_that_was_not_timed_or_has_no_such_error_is_not_on_it) {
  Chart chart = chart_of(
      {point("base", 0.02, {1}), point("untimed", 0.01, {}), point("antialiased", 0.01, {2})});
  chart.points[2].errors[0].reset();
  EXPECT_THAT(front(chart), ElementsAre("base"));
  EXPECT_EQ(pareto_front(chart, rmse(), 1, Space::kRgb).size(), 2u);
}

TEST(Front, does_not_hang_on_a_round_that_was_disturbed) {
  EXPECT_THAT(front(chart_of({point("base", 0.02, {1, 1, 1}), point("slow", 0.01, {3, 0.2, 3})})),
              ElementsAre("slow", "base"));
}

std::vector<Advice> advised(const Chart& chart) { return advice(chart, rmse(), 0, Space::kRgb); }

TEST(Advice, is_the_fastest_within_each_error) {
  const Chart chart = chart_of({point("base", 0.015, {1}), point("slow", 0.003, {3}),
                                point("slower", 0.002, {4}), point("fast", 0.05, {0.5})});
  const std::vector<Advice> found = advised(chart);  // 1/255, 4/255, 16/255
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].take, 1u);
  EXPECT_EQ(found[1].take, 0u);
  EXPECT_EQ(found[2].take, 3u);
  EXPECT_THAT(advice_sentence(chart, rmse(), 0, found[1]),
              HasSubstr("for an error (rmse) of at most 4/255 take "));
  EXPECT_THAT(advice_sentence(chart, rmse(), 0, found[1]), HasSubstr(": 4.00 ms, rmse 0.015"));
}

TEST(Advice, never_takes_what_is_beyond_the_error_though_it_is_hardly_so) {
  const std::vector<Advice> found =
      advised(chart_of({point("base", 4.0 / 255, {1}), point("beyond", 4.001 / 255, {0.5})}));
  EXPECT_EQ(found[1].take, 0u);
}

TEST(Advice, names_the_nearest_where_nothing_is_good_enough) {
  const Chart chart = chart_of({point("base", 0.02, {1}), point("slow", 0.01, {3})});
  const Advice first = advised(chart).front();
  EXPECT_EQ(first.take, std::nullopt);
  EXPECT_EQ(first.nearest, 1u);
  EXPECT_THAT(advice_sentence(chart, rmse(), 0, first),
              HasSubstr("of at most 1/255 no method is good enough; the nearest is "));
  EXPECT_THAT(advice(chart, rmse(), 0, Space::kYiq), IsEmpty());
}

TEST(Advice, is_in_text_and_json_and_on_the_page) {
  const Chart chart = chart_of({point("base", 0.015, {1}), point("slow", 0.003, {3})});
  const auto json = nlohmann::json::parse(chart_json(chart))["advice"]["point"]["rmse"]["rgb"];
  ASSERT_EQ(json.size(), 3u);
  EXPECT_EQ(json[0]["take"], "slow");
  EXPECT_EQ(json[0]["error"], "1/255");
  const std::string sentence = json[1]["sentence"];
  EXPECT_THAT(chart_text(chart, rmse()), HasSubstr(sentence));
  EXPECT_THAT(chart_html(chart, "a scene"), HasSubstr(sentence));
}

TEST(Contested, are_points_whose_spread_reaches_over_the_margin) {
  const std::vector<double> sure{0.5, 0.501, 0.499, 0.5}, unsure{0.93, 0.99, 0.95, 0.92};
  EXPECT_THAT(contested_points(
                  chart_of({point("base", 0.02, {1, 1, 1, 1}), point("sure", 0.03, sure)}), rmse()),
              IsEmpty());
  EXPECT_THAT(
      contested_points(chart_of({point("base", 0.02, {1, 1, 1, 1}), point("unsure", 0.03, unsure)}),
                       rmse()),
      ElementsAre(1u));
}

TEST(Chart, another_program_s_time_is_its_own_and_a_method_s_a_multiple_of_the_baseline_s) {
  Chart chart = chart_of({point("base", 0.02, {1}), point("slow", 0.01, {3, 2, 5})});
  chart.points.push_back({"Cycles", std::nullopt, Space::kRgb, "own timer", {}, {}, {90, 70, 80}});
  EXPECT_EQ(frame_time(chart, chart.points[1])->median, 12);
  EXPECT_EQ(frame_time(chart, chart.points[1])->max, 20);
  EXPECT_EQ(frame_time(chart, chart.points[2])->median, 80);
}

TEST(Chart, json_is_read_again_as_it_was) {
  Chart chart = chart_of({point("base", 0.02, {1, 1.25}), point("yiq", 0.01, {3}, Space::kYiq)});
  chart.points.push_back({"Cycles", std::nullopt, Space::kRgb, "own timer", {}, {}, {90}});
  chart.points[1].errors[0].reset();
  chart.missing.push_back({"Eevee", "Xvfb not found"});
  using Json = nlohmann::ordered_json;
  const Chart again = chart_from(Json::parse(chart_json(chart)));
  EXPECT_EQ(chart_json(again), chart_json(chart));
  EXPECT_EQ(again.points[1].method, chart.points[1].method);
  EXPECT_FALSE(again.points[1].errors[0]);
  EXPECT_THROW(chart_from(Json::object()), Json::exception);
}

TEST(Chart, csv_has_a_row_for_each_point_and_a_field_for_each_number) {
  const std::string csv = chart_csv(chart_of({point("say \"base\"", 0.02, {1})}));
  EXPECT_THAT(csv, HasSubstr("\"say \"\"base\"\"\",rgb,4,4,4,0.02,"));
  const auto first = csv.substr(0, csv.find('\n')), second = csv.substr(first.size() + 1);
  EXPECT_EQ(std::ranges::count(first, ','), 4 + 4 * std::ssize(chart_metrics()));
  EXPECT_EQ(std::ranges::count(second, ','), std::ranges::count(first, ','));
}

/// The fields of a row, of names without commas.
std::vector<std::string> fields(std::istream& csv) {
  std::string line, field;
  std::getline(csv, line);
  std::istringstream row(line);
  std::vector<std::string> all;
  while (std::getline(row, field, ',')) all.push_back(field);
  return all;
}

TEST(Chart, csv_holds_each_point_s_space_and_whether_it_is_on_its_fronts) {
  Chart chart = chart_of({point("base", 0.02, {1}), point("bad", 0.03, {2}),
                          point("yiq", 0.04, {3}, Space::kYiq), point("fine", 0.01, {9})});
  chart.points[3].errors[0].reset();  // so it is on the fronts of the area truth alone
  std::istringstream csv(chart_csv(chart));
  const auto heads = fields(csv);
  const auto column = [&](const std::string& head) {
    return std::size_t(std::ranges::find(heads, head) - heads.begin());
  };
  std::vector<std::string> flags;
  for (int i = 0; i < 4; ++i) {
    const auto row = fields(csv);
    flags.push_back(row.at(column("space")) + row.at(column("on point rmse front")) +
                    row.at(column("on area rmse front")));
  }
  EXPECT_THAT(flags, ElementsAre("rgb11", "rgb00", "yiq11", "rgb01"));
}

TEST(Chart, text_shows_short_and_long_times_with_three_digits) {
  Chart chart = chart_of({point("base", 0.02, {1}), point("slow", 0.01, {54321})});
  chart.points[0].milliseconds = {0.021449};
  EXPECT_THAT(chart_text(chart, rmse()), HasSubstr("0.0214  0.0214..0.0214"));
  EXPECT_THAT(chart_text(chart, rmse()), HasSubstr("1165  1165..1165"));
  chart.points[0].milliseconds = {0.99951};  // rounds up to another digit
  EXPECT_THAT(chart_text(chart, rmse()), HasSubstr(" 1.00  1.00..1.00"));
}

TEST(Chart, page_holds_its_data_and_no_script_of_a_name) {
  Chart chart = chart_of({point("base", 0.02, {1})});
  chart.points[0].how = "</script>";
  const std::string page = chart_html(chart, "<b>scene</b>");
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;scene"));
  EXPECT_THAT(page, HasSubstr("\\u003c/script>"));
  EXPECT_EQ(page.find("http", page.find("http://www.w3.org/2000/svg") + 4), page.npos)
      << "it needs no network";
}

TEST(Chart, page_distinguishes_the_fronts_lines_and_tables_by_their_space) {
  const std::string page = chart_html(chart_of({point("base", 0.02, {1})}), "scene");
  EXPECT_THAT(page, HasSubstr("<p id=\"lines\""));
  EXPECT_THAT(page,
              HasSubstr(R"(mark($("lines"), "line", frontColor(i), true, "front in " + space))"));
  EXPECT_THAT(page, HasSubstr(R"(mark(title, "line", frontColor(i), true, "In " + space)"));
}

TEST(Chart, finished_points_have_errors_and_times) {
  Chart chart = chart_of({point("base", 0.02, {1}), point("untimed", 0.01, {})});
  EXPECT_EQ(finished_points(chart), 1u);
}

}  // namespace
}  // namespace lumaknot::chart
