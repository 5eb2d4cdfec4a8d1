/// How faults are planted in a scene, and the lists of them.
#pragma once

#include "validate/self_test/faults.h"

namespace lumaknot::validate {

using Faults = std::vector<Fault>;

/// A change of the scene as its view alone describes it.
template <class F>
std::function<void(Scene&, const KnotSpec*)> of_view(F change) {
  return [change](Scene& scene, const KnotSpec*) { change(scene.view); };
}

template <class F>
std::function<void(Scene&, const KnotSpec*)> of_material(F change) {
  return [change](Scene& scene, const KnotSpec*) { change(scene.view.material); };
}

template <class F>
std::function<void(Scene&, const KnotSpec*)> of_mesh(F change) {
  return [change](Scene& scene, const KnotSpec*) { change(scene.mesh); };
}

/// `turn` applied to every position and normal.
template <class F>
std::function<void(Scene&, const KnotSpec*)> turned(F turn) {
  return of_mesh([turn](TriangleMesh& mesh) {
    for (Vec3d& p : mesh.positions) p = turn(p);
    for (Vec3d& n : mesh.normals) n = turn(n);
  });
}

template <class F>
std::function<void(Scene&, const KnotSpec*)> of_uvs(F change) {
  return of_mesh([change](TriangleMesh& mesh) {
    for (Vec2d& uv : mesh.uvs) uv = change(uv);
  });
}

template <class F>
std::function<void(Scene&, const KnotSpec*)> of_texels(F change) {
  return [change](Scene& scene, const KnotSpec*) {
    for (Rgb& texel : std::get<TextureImage>(scene.texture).pixels)
      texel = to_rgb(change(to_vec(texel)));
  };
}

template <class F>
std::function<void(Scene&, const KnotSpec*)> of_knot(F change) {
  return [change](Scene& scene, const KnotSpec* knot) {
    KnotSpec other = *knot;
    change(other);
    scene.mesh = knot_mesh(other);
  };
}

/// Camera, mesh and knot; `knot` is null where the scene has none.
void add_placement_faults(Faults& all, const Scene& scene, const KnotSpec* knot);
/// Normals and the texture.
void add_surface_faults(Faults& all, const Scene& scene);
/// Lamps, weights and the lighting model.
void add_light_faults(Faults& all, const Scene& scene);
/// In finished pictures: colours, places, and what no cause describes.
void add_color_faults(Faults& all);
void add_place_faults(Faults& all);
void add_foreign_faults(Faults& all);

}  // namespace lumaknot::validate
