#include "diagnosis/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <nlohmann/json.hpp>

namespace lumaknot::diagnosis {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> kVerdictNames{"agrees", "named", "unknown"};
constexpr std::array<std::string_view, 5> kRungNames{"placement", "surface", "texture", "light",
                                                     "encoding"};
constexpr std::array<std::string_view, 4> kDepthNames{"float", "half", "16 bits", "8 bits"};

Json score_json(const Score& score) {
  return {{"score", score.value},
          {"explained", score.explained},
          {"median", score.median},
          {"p99.9", score.p999}};
}

Json causes_json(const Explained& explained) {
  Json causes = Json::array();
  for (const NamedCause& cause : explained.causes) {
    Json numbers = Json::object();
    for (const NamedNumber& n : cause.numbers) {
      numbers[n.name] = {{"value", n.value}, {"scene", n.scene}};
    }
    causes.push_back({{"id", cause.id},
                      {"rung", kRungNames[std::size_t(cause.rung)]},
                      {"cause", cause.sentence},
                      {"numbers", numbers}});
  }
  return causes;
}

Json facts_json(const Facts& facts) {
  return {{"depth", kDepthNames[std::size_t(facts.depth)]},
          {"limited_to_0_1", facts.limited},
          {"has_alpha", facts.has_alpha},
          {"background", {facts.background.x, facts.background.y, facts.background.z}},
          {"noise", facts.noise}};
}

}  // namespace

std::string report_text(const Diagnosis& diagnosis, const std::string& name) {
  std::string text = fmt::format("{}: {}", name, sentence_of(diagnosis));
  for (const Explained& other : diagnosis.equivalents) {
    std::vector<std::string> sentences;
    sentences.reserve(other.causes.size());
    for (const NamedCause& cause : other.causes) sentences.push_back(cause.sentence);
    text += fmt::format("\n  the same picture also from: {}", fmt::join(sentences, " and "));
  }
  const Facts& facts = diagnosis.facts;
  text += fmt::format("\n  {} per channel, {}; as given, {:.1f} % of its pixels are ours",
                      kDepthNames[std::size_t(facts.depth)],
                      facts.has_alpha ? "alpha is coverage" : "no alpha",
                      100 * diagnosis.as_given.explained);
  return text;
}

std::string report_json(const Diagnosis& diagnosis) {
  const bool unknown = diagnosis.verdict == Diagnosis::Verdict::kUnknown;
  Json equivalents = Json::array();
  for (const Explained& other : diagnosis.equivalents) equivalents.push_back(causes_json(other));
  const Json causes = causes_json(diagnosis.cause);
  const Json json{{"verdict", kVerdictNames[std::size_t(diagnosis.verdict)]},
                  {"sentence", sentence_of(diagnosis)},
                  {"causes", unknown ? Json::array() : causes},
                  {"nearest", unknown ? causes : Json::array()},
                  {"equivalents", equivalents},
                  {"facts", facts_json(diagnosis.facts)},
                  {"as_given", score_json(diagnosis.as_given)},
                  {"residual", score_json(diagnosis.cause.score)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lumaknot::diagnosis
