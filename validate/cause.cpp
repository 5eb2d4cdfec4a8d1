#include "validate/cause.h"

#include <fmt/format.h>

#include <algorithm>

namespace lumaknot::validate {

namespace {

using diagnosis::Rung;

/// "GL's", "Cycles'"
std::string possessive(const std::string& name) {
  return name + (name.ends_with('s') ? "'" : "'s");
}

}  // namespace

Cause find_cause(const Scene& scene, const std::optional<KnotSpec>& knot, const Shot& shot,
                 const Image& drawn, bool limited) {
  return {shot.name, diagnosis::diagnose({scene, shot, drawn, knot, limited, true})};
}

void prefer_by_rung(diagnosis::Diagnosis& diagnosis, FirstDifference first) {
  const auto by_light = [](const diagnosis::NamedCause& cause) {
    return cause.rung == Rung::kLight || cause.rung == Rung::kSurface;
  };
  const auto fits = [&](const diagnosis::Explained& explained) {
    const bool all = std::ranges::all_of(explained.causes, by_light);
    return first == FirstDifference::kCoverage || all == (first == FirstDifference::kLight);
  };
  if (fits(diagnosis.cause)) return;
  const auto better = std::ranges::find_if(diagnosis.equivalents, fits);
  if (better != diagnosis.equivalents.end()) std::swap(*better, diagnosis.cause);
}

std::string rung_of(const diagnosis::Diagnosis& diagnosis, FirstDifference first) {
  if (diagnosis.verdict != diagnosis::Diagnosis::Verdict::kNamed) return {};
  const auto has = [&](Rung rung) {
    return std::ranges::count(diagnosis.cause.causes, rung, &diagnosis::NamedCause::rung) > 0;
  };
  if (has(Rung::kPlacement)) return "placement";
  return has(Rung::kEncoding) && first != FirstDifference::kLight ? "encoding" : "";
}

std::string cause_sentence(const std::string& renderer, const Cause& cause) {
  using Verdict = diagnosis::Diagnosis::Verdict;
  const std::string sentence = diagnosis::sentence_of(cause.diagnosis);
  const std::string picture = fmt::format("{} picture of {}", possessive(renderer), cause.shot);
  if (cause.diagnosis.verdict == Verdict::kNamed) {
    return fmt::format("{} is ours with {}", picture, sentence);
  }
  if (cause.diagnosis.verdict == Verdict::kAgrees) {
    return fmt::format("{} differs by little: no cause stands out", picture);
  }
  return fmt::format("why {} differs is {}", picture, sentence);
}

}  // namespace lumaknot::validate
