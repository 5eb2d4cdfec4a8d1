/// A shot prepared for shading any number of fragments.
#pragma once

#include "render/rasterizer.h"
#include "scene/shot.h"
#include "shaders/formulas/lighting.h"

namespace lumaknot {

/// Colours of a shot, computed in the number type S, double or Half; keeps the scene and the shot
/// by reference.
template <class S>
class ShadingIn {
 public:
  ShadingIn(const Scene& scene, const Shot& shot);

  /// The colour where the fragment lies, the texture bilinear; black where nothing is seen.
  Vec3d color(const Fragment& fragment) const;

  /// The colour with `texture`, the surface's own r'g'b', in place of the texture.
  Vec3d color(const Fragment& fragment, const Vec3d& texture) const;

 private:
  Terms<S> terms_at(const Vec3d& position, const Vec3d& normal) const;
  Terms<S> interpolated_terms(const Fragment& fragment) const;

  const Scene& scene_;
  const Shot& shot_;
  Lighting<S> lighting_;
  bool needs_texture_;
};

using Shading = ShadingIn<double>;

}  // namespace lumaknot
