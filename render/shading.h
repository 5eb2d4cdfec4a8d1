/// A shot ready to be computed at any number of fragments.
#pragma once

#include "render/rasterizer.h"
#include "scene/shot.h"
#include "shaders/lighting.h"

namespace lumaknot {

/// Colours of a shot in double; keeps the scene and the shot by reference.
class Shading {
 public:
  Shading(const Scene& scene, const Shot& shot);

  /// The colour where the fragment lies, the texture bilinear; black where nothing is seen.
  Vec3d color(const Fragment& fragment) const;

  /// The colour where `texture`, the surface's own r'g'b', takes the texture's place.
  Vec3d color(const Fragment& fragment, const Vec3d& texture) const;

 private:
  Terms<double> terms_at(const SurfacePoint<double>& point) const;
  Terms<double> interpolated_terms(const Fragment& fragment) const;

  const Scene& scene_;
  const Shot& shot_;
  Lighting<double> lighting_;
  bool needs_texture_;
};

}  // namespace lumaknot
