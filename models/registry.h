/// The lighting models as values, the numbers that they read, and their terms.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "models/list.h"

namespace lumaknot {

#define LUMAKNOT_MODEL(name) k##name,
enum class Model { LUMAKNOT_MODELS(LUMAKNOT_MODEL) };
#undef LUMAKNOT_MODEL

#define LUMAKNOT_MODEL(name) name::kName,
inline constexpr auto kModelNames =
    std::to_array<std::string_view>({LUMAKNOT_MODELS(LUMAKNOT_MODEL)});
#undef LUMAKNOT_MODEL

/// Calls f(M{}) for each model, where M is the type that describes it.
template <class F>
constexpr void for_each_model(F f) {
#define LUMAKNOT_MODEL(name) f(name{});  // NOLINT(bugprone-macro-parentheses): a type
  LUMAKNOT_MODELS(LUMAKNOT_MODEL)
#undef LUMAKNOT_MODEL
}

/// Calls f(term{}) for each model's highlight, then for each model's diffuse term.
template <class F>
constexpr void for_each_term(F f) {
  for_each_model([&]<class M>(M) { f(typename M::Highlight{}); });
  for_each_model([&]<class M>(M) { f(typename M::Diffuse{}); });
}

/// The parameters of all terms, one of each name, in the order of for_each_term().
struct NamedParameters {
  std::array<Parameter, 32> all{};
  std::size_t count = 0;

  constexpr std::size_t index_of(std::string_view name) const {
    return std::size_t(std::ranges::find(all, name, &Parameter::name) - all.begin());
  }
  static consteval NamedParameters of_all_terms() {
    NamedParameters result;
    for_each_term([&](auto term) {
      for (const Parameter& p : term.kParameters) {
        if (result.index_of(p.name) == result.all.size()) result.all[result.count++] = p;
      }
    });
    return result;
  }
};
inline constexpr NamedParameters kNamedParameters = NamedParameters::of_all_terms();
inline constexpr std::size_t kParameterCount = kNamedParameters.count;

/// The name of a term's parameter: one that no term has does not compile.
class ParameterName {
 public:
  template <class Name>
  consteval ParameterName(const Name& name) : index_(kNamedParameters.index_of(name)) {
    if (index_ >= kParameterCount) throw std::logic_error("no term has this parameter");
  }
  constexpr std::size_t index() const { return index_; }

 private:
  std::size_t index_;
};

/// The parameters in the same order, as scenes see them: with the range of all terms that have one,
/// and meanings that name the models which differ in it.
std::span<const Parameter, kParameterCount> model_parameters();

/// A number for each parameter of the terms.
template <class S>
class ModelParameters {
 public:
  /// The defaults.
  ModelParameters()
      : ModelParameters(from([](std::size_t i) { return S(kNamedParameters.all[i].value); })) {}

  /// number(i) for the i-th.
  template <class F>
  static ModelParameters from(F number) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      return ModelParameters(Numbers{number(i)...});
    }(std::make_index_sequence<kParameterCount>{});
  }

  constexpr S& operator[](ParameterName name) { return numbers_[name.index()]; }
  constexpr const S& operator[](ParameterName name) const { return numbers_[name.index()]; }
  /// A copy with another number.
  ModelParameters with(ParameterName name, S number) const {
    ModelParameters copy = *this;
    copy[name] = std::move(number);
    return copy;
  }
  constexpr S& at(std::size_t i) { return numbers_[i]; }
  constexpr const S& at(std::size_t i) const { return numbers_[i]; }

 private:
  using Numbers = std::array<S, kParameterCount>;
  explicit ModelParameters(Numbers numbers) : numbers_(std::move(numbers)) {}
  Numbers numbers_;
};

/// Calls f(numbers...) with those that `Term` reads.
template <class Term, class S, class F>
constexpr auto with_parameters(const ModelParameters<S>& all, F f) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return f(all[ParameterName(Term::kParameters[i].name)]...);
  }(std::make_index_sequence<Term::kParameters.size()>{});
}

/// Calls f(M{}) for the type M that describes `model`.
template <class F>
constexpr auto with_model(Model model, F f) {
  switch (model) {
#define LUMAKNOT_MODEL(name) \
  case Model::k##name:       \
    return f(name{});  // NOLINT(bugprone-macro-parentheses): a type
    LUMAKNOT_MODELS(LUMAKNOT_MODEL)
#undef LUMAKNOT_MODEL
  }
  throw std::logic_error("no such model");
}

/// Calls f(term, numbers...) for the diffuse term of `model`.
template <class S, class F>
constexpr auto with_diffuse(Model model, const ModelParameters<S>& all, F f) {
  return with_model(model, [&]<class M>(M) {
    using Term = typename M::Diffuse;
    return with_parameters<Term>(all, [&](const auto&... p) { return f(Term{}, p...); });
  });
}

/// Calls f(term, numbers...) for the highlight of `model`.
template <class S, class F>
constexpr auto with_highlight(Model model, const ModelParameters<S>& all, F f) {
  return with_model(model, [&]<class M>(M) {
    using Term = typename M::Highlight;
    return with_parameters<Term>(all, [&](const auto&... p) { return f(Term{}, p...); });
  });
}

}  // namespace lumaknot
