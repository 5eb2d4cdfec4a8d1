/// The paper's scenes in memory, and pictures of them.
#pragma once

#include "render/reference.h"
#include "scene/shot.h"
#include "scene/spec.h"

namespace lumaknot::paper {

/// The built-in scenes of Figure 1; Figure 2's is the first. They differ only in
/// light and material, so their pixels see the same surface.
struct PaperScenes {
  Scene front, back, specular;
  Grid<Fragment> fragments;
};

/// With pictures of `side` x `side` pixels.
PaperScenes paper_scenes(int side);

/// `scene` drawn with `material`, one centred sample per pixel, in double, unlimited.
Image picture(const PaperScenes& scenes, const Scene& scene, const Material& material);

/// `scene`'s own material with the formula called `formula` (scene/presets.h).
Material formula_of(const Scene& scene, std::string_view formula);

/// A stage of the scene with unit normals: texture, L_D, L_S.
Image stage_picture(const PaperScenes& scenes, const Scene& scene, Stage stage);

/// `scene`'s material in whose place, in `base`, it looks as it does in `scene`: its ambient light
/// is in the material's ambient colour. The scenes differ in nothing else but material.
Material transferred(const Scene& scene, const Scene& base);

}  // namespace lumaknot::paper
