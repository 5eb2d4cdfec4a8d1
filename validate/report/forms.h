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

/// A self-contained HTML page: the pictures side by side, ours on hover, the differences x 16, the
/// numbers, versions, seconds and commands.
std::string report_html(const Validation& validation, const ReportHead& head);

/// "agreed", "differed", "failed" or "skipped", as in both forms.
std::string_view outcome(const Judged& shot);

/// The same for the coverage rung.
std::string_view coverage_outcome(const RendererResult& result);

/// "agreed", "differed" or "nothing to compare".
std::string_view verdict_name(Verdict verdict);

}  // namespace lumaknot::validate
