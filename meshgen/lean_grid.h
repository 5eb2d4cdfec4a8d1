/// The leanest grid within a distance of the exact tube.
#pragma once

#include "meshgen/surface.h"
#include "scene/progress.h"

namespace lumaknot {

/// A grid and how far its triangles are off: see Deviation::chord.
struct LeanGrid {
  int segments = 0, sides = 0;
  double chord = 0;  ///< measured, scene units
};

/// The grid of fewest triangles, of all with segments >= 3 and sides >= 3, whose
/// measured_chord() is at most `max_error` scene units; of several, the one that is off least. The
/// components of a link are congruent, so the grid of one is the grid of each. Throws Error when
/// max_error is not > 0, when the tube is thicker than the centre line's radius of curvature, and
/// when the grid would have more than 50 million vertices.
///
/// No grid is accepted but by measuring all of it, and none refused but by the number of its sides
/// or by a triangle of it that is further off, but for grids of far fewer segments than a model
/// wants: least_segments() in grid_model.h says where the trials begin. For the default knot that
/// is 12, 3, 2 and 2 % below the result for errors of 1e-2, 1e-3, 1e-4 and 1e-5.
LeanGrid lean_grid(const TubeSurface& surface, double max_error, const Progress& progress = {});

}  // namespace lumaknot
