#include <deque>
#include <string>
#include <vector>

#include "models/registry.h"

namespace lumaknot {
namespace {

/// A parameter as one model has it.
struct Use {
  std::string_view model;
  Parameter parameter;
};

std::vector<Use> uses_of(std::string_view name) {
  std::vector<Use> uses;
  for_each_model([&]<class M>(M) {
    const auto add = [&](const Parameter& p) {
      if (p.name == name) uses.push_back({M::kName, p});
    };
    std::ranges::for_each(M::Diffuse::kParameters, add);
    std::ranges::for_each(M::Highlight::kParameters, add);
  });
  return uses;
}

std::string meaning_of(const std::vector<Use>& uses) {
  const std::string_view first = uses.front().parameter.meaning;
  const bool agree =
      std::ranges::all_of(uses, [&](const Use& use) { return use.parameter.meaning == first; });
  if (agree && uses.size() > 1) return std::string(first);
  std::string text;
  for (const auto& [model, parameter] : uses) {
    if (!text.empty()) text += "; ";
    text += std::string(model) + ": " + std::string(parameter.meaning);
  }
  return text;
}

/// The parameters, and their meanings' texts.
class Table {
 public:
  Table() {
    for (std::size_t i = 0; i < kParameterCount; ++i) {
      const std::vector<Use> uses = uses_of(kNamedParameters.all[i].name);
      Parameter& p = parameters_[i] = uses.front().parameter;
      p.meaning = meanings_.emplace_back(meaning_of(uses));
      for (const Use& use : uses) include(p.range, use.parameter.range);
    }
  }
  const std::array<Parameter, kParameterCount>& parameters() const { return parameters_; }

 private:
  static void include(Interval<double>& range, const Interval<double>& other) {
    if (other.min < range.min) range.min = other.min;
    if (other.max > range.max) range.max = other.max;
  }
  std::deque<std::string> meanings_;
  std::array<Parameter, kParameterCount> parameters_;
};

}  // namespace

std::span<const Parameter, kParameterCount> model_parameters() {
  static const Table kTable;
  return kTable.parameters();
}

}  // namespace lumaknot
