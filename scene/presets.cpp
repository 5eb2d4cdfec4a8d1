#include "scene/presets.h"

#include <algorithm>

namespace lumaknot {
namespace {

Material table1() {
  Material m;
  m.space = Space::kYiq;
  m.luma_offset = -0.1;
  m.clamp = Clamp::kTable1;
  m.normal = NormalUse::kInterpolated;
  return m;
}

Material eq6() {
  Material m;
  m.space = Space::kYiq;
  return m;
}

bool same_formula(const Material& a, const Material& b) {
  return a.model == b.model && a.space == b.space && a.luma_offset == b.luma_offset &&
         a.clamp == b.clamp && a.normal == b.normal;
}

/// Figure 2: the knot whose counts the paper gives, bricks, one light, 720 x 720.
SceneSpec figure2() {
  SceneSpec scene;
  KnotSpec knot;
  knot.repeat_u = 12;  // bricks about as long on the tube as they are in the image
  scene.mesh = knot;
  return scene;
}

SceneSpec figure1_back() {
  SceneSpec scene = figure2();
  scene.view.light.position = {1.5, 4.0, 1.0};
  return scene;
}

SceneSpec figure1_specular() {
  SceneSpec scene = figure2();
  scene.view.ambient = 0;
  scene.view.material.diffuse = 0;
  return scene;
}

}  // namespace

const std::array<NamedMaterial, 3>& named_materials() {
  static const std::array<NamedMaterial, 3> kMaterials{{
      {"phong", "classical Phong, eq. 3: light acts on every channel", Material{}},
      {"yiq-table1", "YIQ as the paper's HLSL listing: clamps, -0.1, interpolated normal",
       table1()},
      {"yiq-eq6", "YIQ as the paper's eq. 6-8: light acts on luma alone, no clamp", eq6()},
  }};
  return kMaterials;
}

std::optional<Material> with_formula(const Material& base, std::string_view name) {
  const auto found = std::ranges::find(named_materials(), name, &NamedMaterial::name);
  if (found == named_materials().end()) return std::nullopt;
  Material result = found->material;
  result.shininess = base.shininess;
  result.diffuse = base.diffuse;
  result.specular = base.specular;
  return result;
}

std::string_view formula_name(const Material& material) {
  const auto found = std::ranges::find_if(
      named_materials(), [&](const auto& m) { return same_formula(m.material, material); });
  return found == named_materials().end() ? "custom" : found->name;
}

const std::array<NamedScene, 4>& named_scenes() {
  static const std::array<NamedScene, 4> kScenes{{
      {"figure1-front", "Figure 1: the light in front of the knot"},
      {"figure1-back", "Figure 1: the light behind the knot"},
      {"figure1-specular", "Figure 1: specular reflection alone"},
      {"figure2", "Figure 2: 31,529 vertices, 61,440 triangles, bricks, 720 x 720"},
  }};
  return kScenes;
}

std::optional<SceneSpec> builtin_scene(std::string_view name) {
  if (name == "figure1-front" || name == "figure2") return figure2();
  if (name == "figure1-back") return figure1_back();
  if (name == "figure1-specular") return figure1_specular();
  return std::nullopt;
}

}  // namespace lumaknot
