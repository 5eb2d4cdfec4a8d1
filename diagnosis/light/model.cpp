/// Another lighting model, or other parameters of it.
#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

namespace {

bool reads(Model model, std::size_t parameter) {
  return with_model(model, [&]<class M>(M) {
    const auto has = [&](auto term) {
      return std::ranges::count(term.kParameters, model_parameters()[parameter].name,
                                &lumaknot::Parameter::name) > 0;
    };
    return has(typename M::Highlight{}) || has(typename M::Diffuse{});
  });
}

Hypothesis parameter_of(const Situation& situation, std::size_t i) {
  const lumaknot::Parameter& p = model_parameters()[i];
  const double own = situation.setup.view.material.parameters.at(i);
  const std::string name(p.name);
  Hypothesis h{
      .id = name,
      .rung = Rung::kLight,
      .parameters = {{name, own, std::max(0.01 * own, 1e-3), p.range.min,
                      std::min(p.range.max, 1e5)}},
      .apply = [i](Setup& s,
                   std::span<const double> value) { s.view.material.parameters.at(i) = value[0]; },
      .sentence =
          [name, own](std::span<const double> value) {
            return fmt::format("{} {}, not {}", name, number(value[0]), number(own));
          }};
  h.starts = {{own}, {0.4 * own}, {2.5 * own}};
  return h;
}

/// With the parameters that the scene has, and fitted ones where it has none of the model's.
Hypothesis other_model(Model model) {
  const std::string name(kModelNames[std::size_t(model)]);
  return discrete("model-" + name, Rung::kLight, name + " as the lighting model",
                  [model](Setup& s) { s.view.material.model = model; });
}

}  // namespace

std::vector<Hypothesis> model(const Situation& situation) {
  const Model own = situation.setup.view.material.model;
  std::vector<Hypothesis> all;
  for (std::size_t i = 0; i < kParameterCount; ++i) {
    if (reads(own, i)) all.push_back(parameter_of(situation, i));
  }
  for (std::size_t m = 0; m < kModelNames.size(); ++m) {
    if (Model(m) != own) all.push_back(other_model(Model(m)));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
