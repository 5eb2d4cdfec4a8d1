/// The built-in scenes and materials.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/spec.h"

namespace lumaknot {

/// One of the paper's materials.
struct NamedMaterial {
  std::string_view name;
  std::string_view formula;  ///< one of formula_names()
  std::string_view about;
};

/// The paper's lighting: `phong` (eq. 3), `yiq-table1` (the HLSL listing with its clamps, its -0.1
/// and its unnormalised normal) and `yiq-eq6` (eq. 6-8 as printed).
const std::array<NamedMaterial, 3>& paper_materials();

/// The words that a formula's name may begin with: "rgb", "yiq", "yiq-table1", ...
std::vector<std::string_view> space_use_names();

/// Every lighting formula by name, a space and a model: "rgb-phong", "yiq-table1-minnaert",
/// "cielab-cook-torrance", ...
std::vector<std::string> formula_names();

/// `base` with the formula called `name`, one of formula_names() or a paper material's; its numbers
/// are kept. Empty if absent.
std::optional<Material> with_formula(const Material& base, std::string_view name);

/// The name of `material`'s formula, preferably a paper material's, or "custom".
std::string formula_name(const Material& material);

/// The default knot of `convention`. Theirs: three.js's TorusKnotGeometry, Babylon.js's
/// CreateTorusKnot, Blender's add-on with its bevel.
KnotSpec knot_defaults(Convention convention);

/// Whether the minor radius is half the major radius, whatever that is.
bool has_fixed_winding(Convention convention);

/// A scene by name.
struct NamedScene {
  std::string_view name;
  std::string_view about;
};

/// Figure 1's three views and Figure 2's performance scene.
const std::array<NamedScene, 4>& named_scenes();

/// The built-in scene called `name`; empty if absent.
std::optional<SceneSpec> builtin_scene(std::string_view name);

}  // namespace lumaknot
