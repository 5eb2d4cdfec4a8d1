/// A scene that is quick to draw and has highlights, shadows' edges and inner silhouettes.
#pragma once

#include "meshgen/knot_mesh.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "scene/shot.h"
#include "scene/spec.h"

namespace lumaknot::testing {

inline Scene small_scene(int size = 96) {
  KnotSpec knot;
  knot.segments = 120;
  knot.sides = 16;
  Scene scene{knot_mesh(knot), bricks(), builtin_scene("figure2")->view};
  scene.view.image = {size, size, 1};
  return scene;
}

inline Shot final_shot(std::string_view material) {
  return {std::string(material), Stage::kFinal, *with_formula(Material{}, material)};
}

}  // namespace lumaknot::testing
