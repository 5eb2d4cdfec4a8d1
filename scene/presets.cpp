#include "scene/presets.h"

#include "scene/fields.h"

namespace lumaknot {
namespace {

/// The use of a space: one of the words that a formula's name begins with.
struct SpaceUse {
  std::string_view name;
  Space space;
  Form form = Form::kMatrices;
  bool table1 = false;
};

constexpr SpaceUse kSpaceUses[] = {{"rgb", Space::kRgb},
                                   {"yiq", Space::kYiq},
                                   {"yiq-table1", Space::kYiq, Form::kMatrices, true},
                                   {"yiq-collapsed", Space::kYiq, Form::kCollapsed},
                                   {"yiq-baked", Space::kYiq, Form::kBaked},
                                   {"yuv601", Space::kYuv601},
                                   {"yuv709", Space::kYuv709},
                                   {"cielab", Space::kCielab},
                                   {"cieluv", Space::kCieluv},
                                   {"din99", Space::kDin99},
                                   {"atd95", Space::kAtd95}};

/// `base` with the formula of `use` and `model`.
Material with_use(Material base, const SpaceUse& use, Model model) {
  base.model = model;
  base.space = use.space;
  base.form = use.form;
  base.luma_offset = use.table1 ? -0.1 : 0;
  base.clamp = use.table1 ? Clamp::kTable1 : Clamp::kFree;
  base.normal = use.table1 ? NormalUse::kInterpolated : NormalUse::kUnit;
  return base;
}

bool same_formula(const Material& a, const Material& b) {
  return a.model == b.model && a.space == b.space && a.form == b.form &&
         a.luma_offset == b.luma_offset && a.clamp == b.clamp && a.normal == b.normal;
}

/// Calls `visit(name, use, model)` for every formula until it returns true.
template <class F>
void find_formula(F visit) {
  for (const SpaceUse& use : kSpaceUses) {
    for (std::size_t model = 0; model < kModelNames.size(); ++model) {
      const std::string name = std::string(use.name) + "-" + std::string(kModelNames[model]);
      if (visit(name, use, Model(model))) return;
    }
  }
}

/// The full name of a formula that the paper's short names stand for.
std::string_view full_name(std::string_view name) {
  for (const NamedMaterial& m : paper_materials()) {
    if (m.name == name) return m.formula;
  }
  return name;
}

/// Figure 2: the knot whose counts the paper gives, bricks, one light, 720 x 720.
SceneSpec figure2() {
  SceneSpec scene;
  KnotSpec knot;
  knot.unwrap = Unwrap::kParameter;  // as with the tools of its time
  knot.repeat_u = 12;                // bricks about as long on the tube as they are in the image
  scene.mesh = knot;
  return scene;
}

SceneSpec figure1_back() {
  SceneSpec scene = figure2();
  scene.view.lights = {PointLight{.position = {1.5, 4.0, 1.0}, .color = {}, .falloff = {}}};
  return scene;
}

SceneSpec figure1_specular() {
  SceneSpec scene = figure2();
  scene.view.ambient = 0;
  scene.view.material.diffuse = 0;
  return scene;
}

}  // namespace

const std::array<NamedMaterial, 3>& paper_materials() {
  static const std::array<NamedMaterial, 3> kMaterials{{
      {"phong", "rgb-phong", "classical Phong, eq. 3: light acts on every channel"},
      {"yiq-table1", "yiq-table1-phong",
       "YIQ as the paper's HLSL listing: clamps, -0.1, interpolated normal"},
      {"yiq-eq6", "yiq-phong", "YIQ as the paper's eq. 6-8: light acts on luma alone, no clamp"},
  }};
  return kMaterials;
}

std::vector<std::string_view> space_use_names() {
  std::vector<std::string_view> names;
  for (const SpaceUse& use : kSpaceUses) names.push_back(use.name);
  return names;
}

std::vector<std::string> formula_names() {
  std::vector<std::string> names;
  find_formula([&](const std::string& name, const SpaceUse&, Model) {
    names.push_back(name);
    return false;
  });
  return names;
}

std::optional<Material> with_formula(const Material& base, std::string_view name) {
  std::optional<Material> result;
  find_formula([&](const std::string& each, const SpaceUse& use, Model model) {
    if (each == full_name(name)) result = with_use(base, use, model);
    return result.has_value();
  });
  return result;
}

std::string formula_name(const Material& material) {
  std::string found = "custom";
  find_formula([&](const std::string& name, const SpaceUse& use, Model model) {
    const bool same = same_formula(with_use(material, use, model), material);
    if (same) found = name;
    return same;
  });
  for (const NamedMaterial& m : paper_materials()) {
    if (m.formula == found) return std::string(m.name);
  }
  return found;
}

KnotSpec knot_defaults(Convention convention) {
  KnotSpec knot;
  knot.convention = convention;
  const auto sizes = [&](double ring, double winding, double tube, int segments, int sides) {
    knot.major_radius = ring;
    knot.minor_radius = winding;
    knot.tube_radius = tube;
    knot.segments = segments;
    knot.sides = sides;
  };
  if (convention == Convention::kThree) sizes(1, 0.5, 0.4, 64, 8);
  if (convention == Convention::kBabylon) sizes(2, 1, 0.5, 32, 32);
  if (convention == Convention::kBlender) sizes(1, 0.25, 0.04, 99, 8);
  if (has_fixed_winding(convention)) {
    knot.frames = FrameRule::kThree;
    knot.unwrap = Unwrap::kParameter;
  }
  return knot;
}

bool has_fixed_winding(Convention convention) {
  return convention == Convention::kThree || convention == Convention::kBabylon;
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
