/// The result for people and for programs.
#pragma once

#include <string>

#include "validate/run.h"

namespace lumaknot::validate {

/// What the report says about the job besides its result.
struct ReportHead {
  std::string scene;    ///< as named by the user
  std::string command;  ///< to repeat the whole job
};

/// The numbers as JSON, ending in a newline.
std::string report_json(const Validation& validation, const ReportHead& head);

/// A self-contained HTML page: the pictures, to be compared in many ways, then the numbers,
/// versions, seconds and commands.
std::string report_html(const Validation& validation, const ReportHead& head);

/// A JUnit file for build servers: a test case per renderer and rung, without times.
std::string report_junit(const Validation& validation, const ReportHead& head);

/// "agreed", "explained", "differed", "failed" or "skipped", as in all forms.
std::string_view outcome(const Judged& shot);

/// The same for the coverage rung.
std::string_view coverage_outcome(const RendererResult& result);

/// The same for all of a renderer's rungs: "differed" also if only some of its shots failed.
std::string_view renderer_outcome(const RendererResult& result);

/// What was found of a renderer that drew with random samples: how much of what is admitted its
/// pictures use, or where they exceed it, and which bias would have been seen. Empty without such.
std::string noise_summary(const Validation& validation, const RendererResult& result);

/// "agreed", "explained" or "differed".
std::string_view outcome_name(Outcome outcome);

/// "agreed", "explained", "differed" or "nothing to compare".
std::string_view verdict_name(Verdict verdict);

/// "turned normal 18.5 % of the covered pixels".
std::string share_text(const ClassShare& share);

/// Which classes are beyond what is allowed, and the flag that would allow them; `shares` holds
/// one at least.
std::string explanation(const std::vector<ClassShare>& shares);

}  // namespace lumaknot::validate
