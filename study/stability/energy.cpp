#include "study/stability/energy.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace lumaknot {

double reflected_share(const Term& term, double incidence) {
  constexpr int kSteps = 160;
  const Vec3d n{0, 0, 1}, l{-std::sin(incidence), 0, std::cos(incidence)};
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {  // n.v dv is half of d(sin^2) d(azimuth)
    const double square = (i + 0.5) / kSteps, sine = std::sqrt(square);
    for (int j = 0; j < kSteps; ++j) {
      const double azimuth = std::numbers::pi * (j + 0.5) / kSteps;
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
    const double share = reflected_share(term, degrees * std::numbers::pi / 180);
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

Energy diffuse(std::string name, Model model, const ModelNumbers<double>& numbers) {
  return energy_of(std::move(name),
                   [=](const Directions<double>& d) { return diffuse_term(model, d, numbers); });
}

Energy specular(std::string name, Model model, const ModelNumbers<double>& numbers) {
  return energy_of(std::move(name),
                   [=](const Directions<double>& d) { return specular_term(model, d, numbers); });
}

}  // namespace

std::vector<Energy> energies() {
  std::vector<Energy> all;
  all.push_back(diffuse("Lambert", Model::kPhong, {}));
  for (const double k : {0.25, 1.0, 2.0}) {
    all.push_back(diffuse(fmt::format("Minnaert, k = {}", k), Model::kMinnaert, {.darkness = k}));
  }
  for (const double sigma : {0.3, 1.57}) {
    all.push_back(diffuse(fmt::format("Oren-Nayar, sigma = {}", sigma), Model::kOrenNayar,
                          {.roughness = sigma}));
  }
  for (const double k : {1.0, 10.0, 55.0}) {
    const ModelNumbers<double> numbers{.shininess = k};
    all.push_back(specular(fmt::format("Phong, k = {}", k), Model::kPhong, numbers));
    all.push_back(specular(fmt::format("Blinn-Phong, k = {}", k), Model::kBlinnPhong, numbers));
  }
  for (const double roughness : {0.3, 0.6, 1.0}) {
    all.push_back(specular(fmt::format("Cook-Torrance, roughness {}, F0 = 1", roughness),
                           Model::kCookTorrance, {.roughness = roughness, .reflectance = 1}));
  }
  return all;
}

}  // namespace lumaknot
