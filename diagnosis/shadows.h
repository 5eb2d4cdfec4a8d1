/// Which points of a mesh its own surface hides from a light.
#pragma once

#include <memory>
#include <vector>

#include "render/surface_probe.h"

namespace lumaknot::diagnosis {

/// Shadows without penumbra. A light within the mesh's bounding sphere casts none.
class Shadows {
 public:
  /// Keeps `mesh` by reference.
  Shadows(const TriangleMesh& mesh, const std::vector<lumaknot::Light>& lights);

  /// Whether the mesh lies between light number `light` and `position`.
  bool hides(std::size_t light, const Vec3d& position) const;

 private:
  double extent_ = 0;
  std::vector<std::unique_ptr<SurfaceProbe>> lamps_;  ///< null: it casts none
};

}  // namespace lumaknot::diagnosis
