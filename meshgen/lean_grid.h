/// The leanest grid within a distance of the exact tube.
#pragma once

#include "meshgen/surface.h"
#include "system/progress.h"

namespace lumaknot {

/// A grid and its deviation: see Deviation::chord.
struct LeanGrid {
  int segments = 0, sides = 0;
  double chord = 0;  ///< measured, scene units
};

/// The grid of fewest triangles, among all with segments >= 3 and sides >= 3, whose
/// measured_chord() is at most `max_error` scene units; among several, the one with the smallest
/// chord. The components of a link are congruent, so one grid serves all. Throws Error when
/// max_error is not > 0, when the tube is thicker than the centre line's radius of curvature, and
/// when the grid would have more than 50 million vertices.
///
/// A grid is accepted only by measuring all of it, and refused only by its number of sides or by
/// one of its triangles that exceeds the error, except for grids of far fewer segments than a model
/// requires: min_segments() in grid_model.h determines where the trials begin. For the default knot
/// that is 12, 3, 2 and 2 % below the result for errors of 1e-2, 1e-3, 1e-4 and 1e-5.
LeanGrid lean_grid(const TubeSurface& surface, double max_error, const Progress& progress = {});

}  // namespace lumaknot
