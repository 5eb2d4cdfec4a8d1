#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "validate/report/forms.h"
#include "validate/report/page_kit.h"

namespace lumaknot::embedded {
std::string_view junit_template();
}  // namespace lumaknot::embedded

namespace lumaknot::validate {
namespace {

/// One renderer's rung.
struct TestCase {
  std::string_view renderer, rung, outcome;
  std::string message;
};

/// What a test case's element is called; empty for one that passed.
std::string_view element_of(std::string_view outcome) {
  if (outcome == "failed") return "error";
  if (outcome == "skipped") return "skipped";
  return outcome == "agreed" ? "" : "failure";
}

TestCase coverage_case(const RendererResult& result) {
  TestCase test{result.rendering.renderer, "coverage", coverage_outcome(result), {}};
  if (!result.drew_any()) {
    test.message = result.shots.front().drawn.why;
  } else if (test.outcome == "explained") {
    test.message = explanation({result.coverage_share});
  } else if (test.outcome == "differed") {
    test.message = fmt::format("{} {}", result.coverage_unexplained,
                               result.shots.front().noise.scales.empty()
                                   ? "pixels unexplained"
                                   : "blocks of pixels beyond its noise");
    if (!result.coverage_note.empty()) test.message += "; " + result.coverage_note;
  }
  return test;
}

TestCase shot_case(const RendererResult& result, const Shot& shot, const Judged& judged) {
  TestCase test{result.rendering.renderer, shot.name, outcome(judged), judged.drawn.why};
  const Comparison& c = judged.comparison;
  if (test.outcome == "explained") test.message = explanation(exceeded_shares(c.shares));
  if (test.outcome == "differed") test.message = fmt::format("{}", fmt::join(c.exceeded, "; "));
  if (test.outcome == "explained" || test.outcome == "differed") {
    test.message +=
        fmt::format("; all pixels: mean {:.2e}, p99.9 {:.2e}, max {:.2e}", c.mean, c.p999, c.max);
  }
  return test;
}

PageData case_data(const TestCase& test) {
  PageData row;
  row.set("renderer", std::string(test.renderer));
  row.set("rung", std::string(test.rung));
  row.set("outcome", std::string(test.outcome));
  row.set("message", test.message);
  const std::string element(element_of(test.outcome));
  if (!element.empty()) row.set("element", element);
  return row;
}

}  // namespace

std::string report_junit(const Validation& v, const ReportHead& head) {
  std::vector<TestCase> cases;
  for (const RendererResult& result : v.results) {
    cases.push_back(coverage_case(result));
    for (std::size_t i = 0; i < v.shots.size(); ++i) {
      cases.push_back(shot_case(result, v.shots[i], result.shots[i]));
    }
  }
  const auto count = [&](std::string_view element) {
    return std::to_string(std::ranges::count_if(
        cases, [&](const TestCase& test) { return element_of(test.outcome) == element; }));
  };
  PageData page;
  page.set("scene", head.scene);
  page.set("tests", std::to_string(cases.size()));
  page.set("failures", count("failure"));
  page.set("errors", count("error"));
  page.set("skips", count("skipped"));
  page.set("cases", page_list(cases, case_data));
  return kainjow::mustache::mustache(std::string(embedded::junit_template())).render(page);
}

}  // namespace lumaknot::validate
