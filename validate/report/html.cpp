#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "validate/compare/noise_words.h"
#include "validate/noise.h"
#include "validate/renderers/entry.h"
#include "validate/report/forms.h"
#include "validate/report/matrix.h"
#include "validate/report/page_kit.h"

namespace lumaknot::embedded {
std::string_view report_template();
std::string_view report_style();
std::string_view pixels_script();
std::string_view pixels_script_sha256();
std::string_view painting_script();
std::string_view painting_script_sha256();
std::string_view viewer_script();
std::string_view viewer_script_sha256();
std::string_view controls_script();
std::string_view controls_script_sha256();
}  // namespace lumaknot::embedded

namespace lumaknot::validate {
namespace {

using Data = PageData;

std::string details(const Judged& judged) {
  const Comparison& c = judged.comparison;
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < c.classes.size(); ++i) {
    if (c.classes[i]) parts.push_back(fmt::format("{} {}", c.classes[i], kPixelClassNames[i]));
  }
  for (const ClassShare& share : c.shares) {
    if (share.exceeded) parts.push_back("beyond what is allowed: " + share_text(share));
  }
  for (const std::string& line : c.exceeded) parts.push_back("exceeded: " + line);
  if (judged.denoised) parts.push_back(denoised_text(*judged.denoised));
  for (const std::string& line : {judged.drawn.why, judged.drawn.note}) {
    if (!line.empty()) parts.push_back(line);
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

Data row_data(const Shot& shot, const std::string& renderer, const Judged& judged) {
  const Comparison& c = judged.comparison;
  const auto number = [](double x) { return fmt::format("{:.2e}", x); };
  Data row;
  row.set("shot", shot.name);
  row.set("renderer", renderer);
  row.set("outcome", std::string(outcome(judged)));
  row.set("drawn", judged.drawn.status == RenderedShot::Status::kDrawn);
  row.set("coverage", fmt::format("{} of {}", c.coverage_differs, c.covered));
  row.set("mean", number(c.mean));
  row.set("rmse", number(c.rmse));
  row.set("p99", number(c.p99));
  row.set("p999", number(c.p999));
  row.set("max", number(c.max));
  row.set("judged", fmt::format("{:.2e}, {:.2e}", c.mean_unclassed, c.p999_unclassed));
  row.set("max_at", fmt::format("{}, {}", c.max_at.x, c.max_at.y));
  row.set("outliers", std::to_string(c.outliers));
  row.set("details", details(judged));
  return row;
}

Data claims_data(const Shot& shot, const std::string& renderer, const Claims& claims) {
  Data row;
  row.set("shot", shot.name);
  row.set("renderer", renderer);
  row.set("pixels", std::to_string(claims.highlight_pixels));
  row.set("chroma", fmt::format("{:.4f}", claims.highlight_chroma));
  row.set("hue", fmt::format("{:.2f}", claims.hue_shift_degrees));
  row.set("zero", fmt::format("{:.1f}", 100 * claims.clipped_at_zero));
  row.set("one", fmt::format("{:.1f}", 100 * claims.clipped_at_one));
  return row;
}

Data renderers_data(const Validation& v) {
  return page_list(v.results, [](const RendererResult& result) {
    const Rendering& r = result.rendering;
    Data row;
    row.set("name", r.renderer);
    row.set("version", r.version.empty() ? "not run" : r.version);
    row.set("seconds", fmt::format("{:.2f}", r.seconds));
    row.set("limits", std::string(result.promise.reason));
    if (!r.command.empty()) row.set("command", fmt::format("{}", fmt::join(r.command, " ")));
    return row;
  });
}

Data coverage_row(const RendererResult& result) {
  Data row;
  row.set("shot", "coverage");
  row.set("renderer", result.rendering.renderer);
  row.set("outcome", std::string(coverage_outcome(result)));
  row.set("drawn", result.drew_any());
  row.set("coverage", fmt::format("{} of {}", result.coverage_differs,
                                  result.shots.front().comparison.covered));
  if (result.coverage_differs > 0 && !result.shots.front().noise.scales.empty()) {
    row.set("details",
            fmt::format("{} blocks of pixels beyond its noise", result.coverage_differs));
  } else if (result.coverage_differs > 0) {
    row.set("details", fmt::format("{} where an edge passes by the sample, {} unexplained",
                                   result.coverage_differs - result.coverage_unexplained,
                                   result.coverage_unexplained));
  }
  return row;
}

Data comparison_rows(const Validation& v) {
  Data list(Data::type::list);
  for (const RendererResult& result : v.results) list.push_back(coverage_row(result));
  for (std::size_t s = 0; s < v.shots.size(); ++s) {
    for (const RendererResult& result : v.results) {
      list.push_back(row_data(v.shots[s], result.rendering.renderer, result.shots[s]));
    }
  }
  return list;
}

Data claims_rows(const Validation& v) {
  Data list(Data::type::list);
  for (std::size_t s = 0; s < v.shots.size(); ++s) {
    if (v.shots[s].stage != Stage::kFinal || v.sampling) continue;
    list.push_back(claims_data(v.shots[s], v.own.renderer, v.own_claims[s]));
    for (const RendererResult& result : v.results) {
      const Judged& judged = result.shots[s];
      if (judged.drawn.status != RenderedShot::Status::kDrawn) continue;
      list.push_back(claims_data(v.shots[s], result.rendering.renderer, judged.claims));
    }
  }
  return list;
}

/// The renderers of `outcome`, as in "Cycles, GL and Vulkan".
std::string names_of(const Validation& v, std::string_view outcome) {
  std::vector<std::string> names;
  for (const RendererResult& result : v.results) {
    if (renderer_outcome(result) == outcome) names.push_back(result.rendering.renderer);
  }
  if (names.size() < 2) return names.empty() ? "" : names.front();
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("{} and {}", fmt::join(names, ", "), last);
}

/// What became of a renderer that did not agree, as the end of a sentence.
std::string finding(const Validation& v, const RendererResult& result) {
  if (!result.first_difference.empty()) {
    return fmt::format("differs, first in {}. {}{}", result.first_difference, result.cause,
                       noise_summary(v, result));
  }
  const auto is_drawn = [](const Judged& judged) {
    return judged.drawn.status == RenderedShot::Status::kDrawn;
  };
  const auto undrawn = std::ranges::find_if_not(result.shots, is_drawn);
  if (result.outcome() == Outcome::kExplained) {
    return fmt::format("is explained: {}. {}", explanation(result.explained), result.cause);
  }
  return fmt::format("{}: {}", outcome(*undrawn), undrawn->drawn.why);
}

/// The page's first sentences: each renderer that did not agree, and those that did.
Data findings_data(const Validation& v) {
  Data list(Data::type::list);
  const auto add = [&](const std::string& who, std::string_view outcome, const std::string& what) {
    Data row;
    row.set("who", who);
    row.set("outcome", std::string(outcome));
    row.set("what", what);
    list.push_back(row);
  };
  for (const RendererResult& result : v.results) {
    const std::string_view outcome = renderer_outcome(result);
    if (outcome != "agreed") add(result.rendering.renderer, outcome, finding(v, result));
  }
  const std::string agreed = names_of(v, "agreed");
  if (agreed.empty()) return list;
  std::string what = "agreed with the reference in every picture drawn.";
  if (v.sampling) what += " " + noise_summary(v, v.results.front());
  add(agreed, "agreed", what);
  return list;
}

Data noise_row(const Validation& v, std::size_t shot, const NoiseTest& test, std::size_t scale) {
  const NoiseScale& s = test.scales[scale];
  const auto number = [](double x) { return fmt::format("{:.2e}", x); };
  Data row;
  row.set("shot", v.shots[shot].name);
  row.set("scale", scale_name(test, scale));
  row.set("tests", std::to_string(s.tests));
  row.set("exceeded", std::to_string(s.exceeded + s.coverage_exceeded));
  row.set("noise", number(s.noise));
  row.set("bias", number(s.worst.bias));
  row.set("admitted", number(s.worst.admitted));
  row.set("place", fmt::format("{}, {}", s.worst.place.x, s.worst.place.y));
  row.set("channel", std::string(kChannelNames[s.worst.channel]));
  row.set("seen", number(s.seen));
  return row;
}

/// Every scale of every picture that was drawn with random samples.
Data noise_rows(const Validation& v) {
  Data list(Data::type::list);
  for (const RendererResult& result : v.results) {
    for (std::size_t i = 0; i < result.shots.size(); ++i) {
      const NoiseTest& test = result.shots[i].noise;
      for (std::size_t scale = 0; scale < test.scales.size(); ++scale) {
        list.push_back(noise_row(v, i, test, scale));
      }
    }
  }
  return list;
}

/// What the page says of random samples.
void set_noise(const Validation& v, Data& page) {
  page.set("sampled", v.sampling.has_value());
  if (!v.sampling) return;
  page.set("samples", std::to_string(v.sampling->samples));
  page.set("seeds", fmt::format("{} and {}", v.sampling->seed, v.sampling->seed + 1));
  page.set("family_error", fmt::format("{}", kFamilyError));
  page.set("noise", noise_rows(v));
}

/// The scripts, in order, each with the hash by which the page's policy admits it.
Data scripts_data() {
  Data list(Data::type::list);
  const auto add = [&](std::string_view text, std::string_view hash) {
    Data script;
    script.set("text", std::string(text));
    script.set("hash", std::string(hash));
    list.push_back(script);
  };
  add(embedded::pixels_script(), embedded::pixels_script_sha256());
  add(embedded::painting_script(), embedded::painting_script_sha256());
  add(embedded::viewer_script(), embedded::viewer_script_sha256());
  add(embedded::controls_script(), embedded::controls_script_sha256());
  return list;
}

}  // namespace

std::string report_html(const Validation& v, const ReportHead& head) {
  Data page;
  page.set("scene", head.scene);
  page.set("command", head.command);
  page.set("verdict", std::string(verdict_name(v.verdict)));
  page.set("verdict_class", v.verdict == Verdict::kNothingToCompare
                                ? "skipped"
                                : std::string(verdict_name(v.verdict)));
  page.set("seconds", fmt::format("{:.1f}", v.seconds));
  page.set("width", std::to_string(v.own.shots.front().image.width));
  page.set("height", std::to_string(v.own.shots.front().image.height));
  page.set("findings", findings_data(v));
  set_matrix(v, page);
  page.set("report_style", std::string(embedded::report_style()));
  page.set("scripts", scripts_data());
  page.set("viewer_json", viewer_json(v));
  page.set("own_version", v.own.version);
  page.set("own_seconds", fmt::format("{:.2f}", v.own.seconds));
  page.set("renderers", renderers_data(v));
  page.set("rows", comparison_rows(v));
  page.set("claims", claims_rows(v));
  set_noise(v, page);
  return render_page(embedded::report_template(), std::move(page));
}

}  // namespace lumaknot::validate
