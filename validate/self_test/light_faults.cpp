/// Faults of lamps, weights and the lighting model.
#include "math/angle.h"
#include "validate/self_test/planting.h"

namespace lumaknot::validate {
namespace {

void add_lamp_faults(Faults& all, const Scene& scene) {
  const auto* lamp = std::get_if<PointLight>(&scene.view.lights.front());
  if (!lamp) return;
  const std::string light = scene.view.lights.size() > 1 ? "light-1-" : "light-";
  const std::string suffix = scene.view.lights.size() > 1 ? "-1" : "";
  const auto of_lamp = [](auto change) {
    return of_view([change](View& v) { change(std::get<PointLight>(v.lights.front())); });
  };
  const Vec3d p = lamp->position;
  all.push_back({.what = "lamp moved a little",
                 .names = {light + "position"},
                 .numbers = {{"x", p.x}, {"y", p.y}, {"z", p.z - 0.3}},
                 .scene = of_lamp([](PointLight& l) { l.position.z -= 0.3; })});
  all.push_back({.what = "lamp mirrored",
                 .names = {light + "position"},
                 .numbers = {{"x", -p.x}, {"y", p.y}, {"z", p.z}},
                 .scene = of_lamp([](PointLight& l) { l.position.x *= -1; })});
  for (const double factor : {0.5, 1.02, 2.0}) {
    all.push_back({.what = "lamp's intensity",
                   .names = {light + "intensity", "exposure"},
                   .numbers = {{"factor", factor}},
                   .scene = of_lamp([factor](PointLight& l) { l.color.intensity *= factor; })});
  }
  all.push_back({.what = "lamp times pi",
                 .names = {light + "times-pi", light + "intensity"},
                 .scene = of_lamp([](PointLight& l) { l.color.intensity *= kPi; })});
  all.push_back({.what = "lamp divided by pi",
                 .names = {light + "by-pi", light + "intensity"},
                 .scene = of_lamp([](PointLight& l) { l.color.intensity /= kPi; })});
  all.push_back({.what = "no lamp",
                 .names = {light + "missing", light + "intensity"},
                 .scene = of_lamp([](PointLight& l) { l.color.intensity = 0; })});
  all.push_back({.what = "light falls off with the square",
                 .names = {"falloff-quadratic" + suffix},
                 .numbers = {{"scale", 0.05}},
                 .scene = of_lamp([](PointLight& l) { l.falloff = {0, 0, 0.05}; })});
  all.push_back({.what = "light falls off linearly",
                 .names = {"falloff-linear" + suffix},
                 .numbers = {{"scale", 0.25}},
                 .scene = of_lamp([](PointLight& l) { l.falloff = {0, 0.25, 0}; })});
  all.push_back({.what = "directional light instead",
                 .names = {"directional" + suffix},
                 .scene = of_view([](View& v) {
                   const auto l = std::get<PointLight>(v.lights.front());
                   v.lights.front() = DirectionalLight{-l.position, l.color};
                 })});
  if (scene.view.material.space == Space::kRgb) {
    all.push_back({.what = "lamp tinted",
                   .names = {light + "color", "white-balance"},
                   .numbers = {{"r", 1}, {"g", 0.8}, {"b", 0.6}},
                   .scene = of_lamp([](PointLight& l) { l.color.rgb = {1, 0.8, 0.6}; })});
  }
}

void add_weight_faults(Faults& all, const Scene& scene) {
  const View& view = scene.view;
  all.push_back({.what = "another lamp",
                 .names = {"extra-light"},
                 .numbers = {{"x", 2}, {"y", -2}, {"z", 1}, {"intensity", 0.4}},
                 .scene = of_view([](View& v) {
                   v.lights.emplace_back(PointLight{{2, -2, 1}, {{1, 1, 1}, 0.4}, {}});
                 })});
  all.push_back({.what = "headlight",
                 .names = {"headlight", "extra-light"},
                 .numbers = {{"intensity", 0.3}},
                 .scene = of_view([](View& v) {
                   v.lights.emplace_back(PointLight{v.camera.position, {{1, 1, 1}, 0.3}, {}});
                 })});
  for (const double value : {0.5 * view.ambient, 2 * view.ambient, view.ambient + 0.3}) {
    all.push_back({.what = "ambient light",
                   .names = {"ambient", "emissive", "ambient-color"},
                   .numbers = {{"ambient", value}},
                   .scene = of_view([value](View& v) { v.ambient = value; })});
  }
  all.push_back({.what = "no ambient light",
                 .names = {"ambient-none", "ambient", "ambient-color"},
                 .scene = of_view([](View& v) { v.ambient = 0; })});
  for (const double factor : {0.5, 0.9, 1.5}) {
    all.push_back({.what = "diffuse weight",
                   .names = {"diffuse"},
                   .numbers = {{"factor", factor}},
                   .scene = of_material([factor](Material& m) { m.diffuse *= factor; })});
    all.push_back({.what = "specular weight",
                   .names = {"specular", "specular-color"},
                   .numbers = {{"factor", factor}},
                   .scene = of_material([factor](Material& m) { m.specular *= factor; })});
  }
  all.push_back({.what = "no highlights",
                 .names = {"specular-none", "specular"},
                 .scene = of_material([](Material& m) { m.specular = 0; })});
  all.push_back({.what = "no diffuse light",
                 .names = {"diffuse-none", "diffuse"},
                 .scene = of_material([](Material& m) { m.diffuse = 0; })});
  all.push_back({.what = "highlights gated or not",
                 .names = {view.material.highlights == Highlights::kFree ? "highlights-gated"
                                                                         : "highlights-free"},
                 .scene = of_material([](Material& m) {
                   m.highlights =
                       m.highlights == Highlights::kFree ? Highlights::kGated : Highlights::kFree;
                 })});
  if (view.material.space == Space::kRgb) {
    all.push_back({.what = "highlights tinted",
                   .names = {"specular-color"},
                   .numbers = {{"r", 1}, {"g", 0.7}, {"b", 0.4}},
                   .scene = of_material([](Material& m) { m.specular_color = {1, 0.7, 0.4}; })});
  }
}

void add_model_faults(Faults& all, const Scene& scene) {
  const Material& own = scene.view.material;
  if (own.model == Model::kPhong || own.model == Model::kBlinnPhong) {
    for (const double shininess : {10.0, 50.0, 200.0}) {
      all.push_back({.what = "shininess",
                     .names = {"shininess"},
                     .numbers = {{"shininess", shininess}},
                     .scene = of_material(
                         [shininess](Material& m) { m.parameters["shininess"] = shininess; })});
    }
  }
  for (std::size_t m = 0; m < kModelNames.size(); ++m) {
    if (Model(m) == own.model) continue;
    all.push_back({.what = std::string(kModelNames[m]) + " instead",
                   .names = {"model-" + std::string(kModelNames[m])},
                   .scene = of_material([m](Material& material) { material.model = Model(m); })});
  }
  const auto space = [&](std::string_view name, Space value) {
    if (own.space == value) return;
    all.push_back({.what = "light in " + std::string(name),
                   .names = {"space-" + std::string(name)},
                   .scene = of_material([value](Material& m) { m.space = value; })});
  };
  space("rgb", Space::kRgb);
  space("yiq", Space::kYiq);
  space("yuv709", Space::kYuv709);
  space("cielab", Space::kCielab);
  if (own.clamp == Clamp::kFree) {
    all.push_back({.what = "Table 1's clamps",
                   .names = {"clamp-table1"},
                   .scene = of_material([](Material& m) { m.clamp = Clamp::kTable1; })});
  }
}

}  // namespace

void add_light_faults(Faults& all, const Scene& scene) {
  add_lamp_faults(all, scene);
  add_weight_faults(all, scene);
  add_model_faults(all, scene);
}

}  // namespace lumaknot::validate
