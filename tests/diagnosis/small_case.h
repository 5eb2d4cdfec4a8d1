/// A scene that is diagnosed in a second, and our picture of it.
#pragma once

#include "render/reference.h"
#include "tests/validate/small_scene.h"

namespace lumaknot::diagnosis::testing {

inline KnotSpec small_knot() {
  KnotSpec knot = std::get<KnotSpec>(builtin_scene("figure2")->mesh);
  knot.segments = 120;
  knot.sides = 16;
  return knot;
}

inline Scene small_case() {
  Scene scene{knot_mesh(small_knot()), bricks(), builtin_scene("figure2")->view};
  scene.view.image = {96, 72, 1};
  return scene;
}

inline Image own_picture(const Scene& scene) {
  const Shot shot{"final", Stage::kFinal, scene.view.material};
  return shade_all(scene, shot, visible_fragments(scene));
}

}  // namespace lumaknot::diagnosis::testing
