/// Clip distances.
#pragma once

#include "math/interval.h"
#include "scene/spec.h"

namespace lumaknot::validate {

/// Clip distances that just hold the parts of the mesh in the view: a depth buffer is finest that
/// way. A mesh about the camera is mostly outside.
Interval<double> depth_range(const TriangleMesh& mesh, const Camera& camera,
                             const ImageSpec& image);

}  // namespace lumaknot::validate
