#include "study/stability/energy.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "math/angle.h"

namespace lumaknot::stability {

double reflected_share(const Term& term, double incidence) {
  constexpr int kSteps = 160;
  const Vec3d n{0, 0, 1}, l{-std::sin(incidence), 0, std::cos(incidence)};
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {  // n.v dv is half of d(sin^2) d(azimuth)
    const double square = (i + 0.5) / kSteps, sine = std::sqrt(square);
    for (int j = 0; j < kSteps; ++j) {
      const double azimuth = kPi * (j + 0.5) / kSteps;
      const Vec3d v{sine * std::cos(azimuth), sine * std::sin(azimuth), std::sqrt(1 - square)};
      sum += term({n, l, v, l.z});
    }
  }
  return sum / (kSteps * kSteps) / l.z;
}

Energy energy_of(std::string name, const Term& term) {
  Energy energy{std::move(name)};
  double min = std::numeric_limits<double>::infinity();
  for (int degrees = 0; degrees <= 89; ++degrees) {
    const double share = reflected_share(term, degrees * kPi / 180);
    if (share > energy.max) {
      energy.max = share;
      energy.at_degrees = degrees;
    }
    min = std::min(min, share);
    constexpr double kIntegration = 1e-3;
    if (share > 1 + kIntegration && energy.above_degrees < 0) energy.above_degrees = degrees;
  }
  constexpr double kRounding = 1e-9;  // of the integral's 25600 terms
  if (energy.max - min <= kRounding * energy.max) energy.at_degrees = -1;
  return energy;
}

namespace {

/// A line of the table that is still to be computed.
struct Row {
  std::string_view name;
  Term term;
  std::size_t group, sample;
};

/// Adds the samples of the term T, unless another model has already.
template <class T>
void add_rows(std::vector<Row>& rows, std::vector<std::vector<std::string_view>>& groups, T) {
  std::vector<std::string_view> names;
  names.reserve(T::kParameters.size());
  for (const Parameter& p : T::kParameters) names.push_back(p.name);
  const auto group = std::ranges::find(groups, names);
  const std::size_t index(group - groups.begin());
  if (group == groups.end()) groups.push_back(names);
  for (std::size_t i = 0; i < T::kEnergySamples.size(); ++i) {
    const auto& sample = T::kEnergySamples[i];
    if (std::ranges::count(rows, sample.name, &Row::name) > 0) continue;
    const Term term = [&sample](const Directions<double>& d) {
      return std::apply([&d](const auto&... p) { return T::value(d, p...); }, sample.numbers);
    };
    rows.push_back({sample.name, term, index, i});
  }
}

void add_energies(std::vector<Energy>& all, std::vector<Row> rows) {
  std::ranges::stable_sort(rows, {},
                           [](const Row& row) { return std::pair(row.group, row.sample); });
  for (const Row& row : rows) all.push_back(energy_of(std::string(row.name), row.term));
}

}  // namespace

std::vector<Energy> energies() {
  std::vector<Row> diffuse, highlights;
  std::vector<std::vector<std::string_view>> diffuse_groups, highlight_groups;
  for_each_model([&]<class M>(M) {
    add_rows(diffuse, diffuse_groups, typename M::Diffuse{});
    add_rows(highlights, highlight_groups, typename M::Highlight{});
  });
  std::vector<Energy> all;
  add_energies(all, std::move(diffuse));
  add_energies(all, std::move(highlights));
  return all;
}

}  // namespace lumaknot::stability
