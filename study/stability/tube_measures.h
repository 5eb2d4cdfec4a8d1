/// Errors of a tube.
#pragma once

#include "scene/spec.h"

namespace lumaknot::stability {

/// How deep the tube of the knot's first component reaches into itself, as a share of its radius:
/// the largest amount by which one of its 128 x 24 points is closer to the centre line than the
/// radius.
double overlap(const KnotSpec& knot);

/// How far the grid's triangles are from the exact tube, as a share of its radius.
double chord_share(const KnotSpec& knot);

}  // namespace lumaknot::stability
