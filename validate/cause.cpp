#include "validate/cause.h"

#include <fmt/format.h>

namespace lumaknot::validate {

Cause find_cause(const Scene& scene, const std::optional<KnotSpec>& knot, const Shot& shot,
                 const Image& drawn, bool limited) {
  return {shot.name, diagnosis::diagnose({scene, shot, drawn, knot, limited, true})};
}

std::string cause_sentence(const std::string& renderer, const Cause& cause) {
  using Verdict = diagnosis::Diagnosis::Verdict;
  const std::string sentence = diagnosis::sentence_of(cause.diagnosis);
  if (cause.diagnosis.verdict == Verdict::kNamed) {
    return fmt::format("{}'s picture of {} is ours with {}", renderer, cause.shot, sentence);
  }
  if (cause.diagnosis.verdict == Verdict::kAgrees) {
    return fmt::format("{}'s picture of {} differs by little: no cause stands out", renderer,
                       cause.shot);
  }
  return fmt::format("the cause in {}'s picture of {} is {}", renderer, cause.shot, sentence);
}

}  // namespace lumaknot::validate
