// Models that reflect more light than they get.
#include <algorithm>

#include "math/angle.h"
#include "study/stability/energy.h"
#include "study/stability/regions.h"
#include "study/stability/test_scenes.h"

namespace lumaknot::stability {
namespace {

/// The knot as a furnace would show it: each point as bright as the share that the term reflects at
/// its n.v, up to `most` degrees; red where that is above 1.
Image draw_furnace(const Term& term, int side, double max = 90) {
  std::vector<double> shares;
  for (int degrees = 0; degrees <= 89; ++degrees) {
    shares.push_back(reflected_share(term, degrees * kDegree));
  }
  const Scene scene = knot_scene(Material{});
  return shade_each(scene, side, [&](const Fragment& f) {
    const double cosine = dot(unit(f.normal), unit(scene.view.camera.position - f.position));
    const double degrees = std::acos(std::clamp(cosine, 0.0, 1.0)) / kDegree;
    if (degrees > max) return Vec3d{};
    const double share = shares[std::size_t(std::min(degrees, 89.0))];
    constexpr double kIntegration = 1e-3;
    return share > 1 + kIntegration ? Vec3d{1, 0, 0} : grey(0.8 * share);
  });
}

Term specular(Model model, double shininess) {
  return [=](const Directions<double>& d) {
    return specular_term(model, d,
                         ModelParameters<double>()
                             .with("shininess", shininess)
                             .with("roughness", 0.6)
                             .with("reflectance", 1));
  };
}

Region energy(std::string name, std::string method) {
  Region region;
  region.name = std::move(name);
  region.group = "Energy";
  region.method = std::move(method);
  region.measured = "reflected share of the light";
  region.limit = 1.001;  // the integral is known to 1e-3
  return region;
}

/// Highlights that nothing weakens at grazing incidence.
Region flat_light(std::string name, std::string method, Model model) {
  constexpr double kShininess = 10;
  Region region = energy(std::move(name), std::move(method));
  region.reason =
      "the highlight does not fall with n.l, though the light that arrives does: the share goes to "
      "infinity at grazing light";
  region.remedy = "Cook-Torrance (here roughness 0.6, F0 = 1)";
  region.sweep = {"incidence, degrees", 0, 89.9};
  region.error = [=](double a) {
    return reflected_share(specular(model, kShininess), a * kDegree);
  };
  region.guarded = [](double a) {
    return reflected_share(specular(Model::kCookTorrance, 0), a * kDegree);
  };
  region.sketch = [=](double a, int side) {
    return draw_furnace(specular(model, kShininess), side, a);
  };
  region.guarded_sketch = [](double a, int side) {
    return draw_furnace(specular(Model::kCookTorrance, 0), side, a);
  };
  region.shown_holds = 80;
  return region;
}

Term minnaert(double darkness) {
  return [=](const Directions<double>& d) {
    return diffuse_term(Model::kMinnaert, d, ModelParameters<double>().with("darkness", darkness));
  };
}

Region minnaert_energy() {
  Region region = energy("energy-minnaert", "Minnaert's term at normal incidence");
  region.reason = "2 / (k + 1) of the light comes back: more than all for k < 1";
  region.remedy = "k >= 1, or the albedo times (k + 1) / 2";
  region.sweep = {"darkness k", 2, 0};
  region.error = [](double k) { return reflected_share(minnaert(k), 0); };
  region.guarded = [](double k) {
    return reflected_share(minnaert(k), 0) * std::min(1.0, (k + 1) / 2);
  };
  region.sketch = [](double k, int side) { return draw_furnace(minnaert(k), side); };
  region.guarded_sketch = [](double, int side) { return draw_furnace(minnaert(1), side); };
  region.guarded_shows = [](double) { return "k = 1"; };
  region.shown_holds = 1.5;
  region.shown_fails = 0.5;
  return region;
}

Term lambert_and_phong(double diffuse, double weight) {
  return [=](const Directions<double>& d) {
    const auto numbers = ModelParameters<double>().with("shininess", 10);
    return diffuse * diffuse_term(Model::kPhong, d, numbers) +
           weight * specular_term(Model::kPhong, d, numbers);
  };
}

Region sum_of_terms() {
  Region region = energy("energy-sum", "Lambert with weight 1 and Phong's highlight on top");
  region.reason = "the diffuse term alone sends back all there is";
  region.remedy = "weights that add up to 1 at most";
  region.sweep = {"weight of the highlight, k = 10", 0, 1};
  region.error = [](double w) { return reflected_share(lambert_and_phong(1, w), 0); };
  region.guarded = [](double w) { return reflected_share(lambert_and_phong(1 - w, w), 0); };
  region.sketch = [](double w, int side) { return draw_furnace(lambert_and_phong(1, w), side); };
  region.guarded_sketch = [](double w, int side) {
    return draw_furnace(lambert_and_phong(1 - w, w), side);
  };
  return region;
}

}  // namespace

std::vector<Region> energy_regions() {
  return {flat_light("energy-phong", "Phong's highlight alone, k = 10", Model::kPhong),
          flat_light("energy-blinn-phong", "Blinn's highlight alone, k = 10", Model::kBlinnPhong),
          minnaert_energy(), sum_of_terms()};
}

std::vector<Region> all_regions() {
  std::vector<Region> all;
  for (auto* chapter :
       {frame_regions, grid_regions, texture_regions, float_regions, half_regions,
        highlight_regions, light_regions, model_regions, color_regions, energy_regions}) {
    for (Region& region : chapter()) all.push_back(std::move(region));
  }
  return all;
}

}  // namespace lumaknot::stability
