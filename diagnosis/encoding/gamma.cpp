/// Gamma, or the transfer function of sRGB.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

namespace {

struct Rule {
  Below below;
  std::string_view suffix, words;
};

constexpr std::array<Rule, 3> kRules{
    {{Below::kOdd, "", ""},
     {Below::kZero, "-positive", ", negative values cut off"},
     {Below::kStraight, "-straight", ", negative values straight"}}};

Hypothesis curve(const std::string& id, const std::string& words, Curve curve, const Rule& rule) {
  Hypothesis h = discrete(id + std::string(rule.suffix), Rung::kEncoding,
                          words + std::string(rule.words), [curve, below = rule.below](Setup& s) {
                            s.color.curve = curve;
                            s.color.below = below;
                          });
  h.special = true;
  return h;
}

}  // namespace

std::vector<Hypothesis> gamma(const Situation& situation) {
  std::vector<Hypothesis> all;
  for (const Rule& rule : kRules) {
    if (rule.below != Below::kOdd && !situation.negative) continue;
    all.push_back(continuous("gamma" + std::string(rule.suffix), Rung::kEncoding,
                             {"gamma", 1, 0.02, 0.1, 10}, "gamma {:.4g}" + std::string(rule.words),
                             [below = rule.below](Setup& s, double gamma) {
                               s.color.gamma = gamma;
                               s.color.below = below;
                             }));
    all.push_back(curve("srgb-encoded", "an encoding as sRGB", Curve::kEncodeSrgb, rule));
    all.push_back(curve("srgb-decoded", "a decoding from sRGB", Curve::kDecodeSrgb, rule));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
