#include "validate/cause.h"

#include <fmt/format.h>

namespace lumaknot::validate {

namespace {

/// "GL's", "Cycles'"
std::string possessive(const std::string& name) {
  return name + (name.ends_with('s') ? "'" : "'s");
}

}  // namespace

Cause find_cause(const Scene& scene, const std::optional<KnotSpec>& knot, const Shot& shot,
                 const Image& drawn, bool limited) {
  return {shot.name, diagnosis::diagnose({scene, shot, drawn, knot, limited, true})};
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
