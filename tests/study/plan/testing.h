/// Scenes that plans are tested with.
#pragma once

#include "meshgen/knot_mesh.h"
#include "render/exact/truth.h"
#include "scene/bricks.h"
#include "scene/spec.h"
#include "study/plan/outcome.h"

namespace lumaknot::plan {

/// A trefoil of one colour, lit by one lamp, so many pixels a side.
inline SceneSpec small_spec(int side = 96) {
  SceneSpec spec;
  spec.mesh = KnotSpec{.segments = 192, .sides = 16};
  spec.texture = PlainColor{{0.8, 0.4, 0.2}};
  spec.view.image = {side, side, 1};
  return spec;
}

inline const KnotSpec& knot_of(const SceneSpec& spec) { return std::get<KnotSpec>(spec.mesh); }

inline Scene made(const SceneSpec& spec) {
  const auto* color = std::get_if<PlainColor>(&spec.texture);
  return {knot_mesh(knot_of(spec)), color ? Texture(color->rgb) : Texture(bricks()), spec.view};
}

inline std::vector<Fragment> seen_of(const SceneSpec& spec) {
  std::vector<Fragment> seen;
  const Scene scene = made(spec);
  for (const exact::ExactFragment& f : exact::exact_fragments(scene, knot_of(spec)).pixels) {
    if (f.fragment.covered()) seen.push_back(f.fragment);
  }
  return seen;
}

}  // namespace lumaknot::plan
