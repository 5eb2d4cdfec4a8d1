/// A smooth model of a grid's error, which guides the search of lean_grid.h.
#pragma once

#include <vector>

#include "meshgen/surface.h"

namespace lumaknot {

/// Where the surface bends most along the tube, and by how much.
struct Peak {
  double t, bulge;
};

/// A point where a grid is likely to be worst, in radians.
struct Witness {
  double t, theta;
};

/// The tube's properties that the search uses.
struct GridModel {
  const TubeSurface& surface;
  Peak peak;         ///< the highest
  double turning;    ///< s K there: the centre line's angle per radian of t
  double twist;      ///< -X_tk . n = r s w there
  double sharpness;  ///< the largest curvature of the centre line
  std::vector<Witness> witnesses;
};

GridModel grid_model(const TubeSurface& surface);

/// The error of a ring's own polygon, which no number of segments reduces: exact, since an edge's
/// midpoint lies in the ring's plane, which is normal to the centre line.
double ring_error(const GridModel& model, int sides);

/// The fewest sides, at least 3, whose rings meet the error.
int min_sides(const GridModel& model, double max_error);

/// The fewest segments worth a trial, 3 ... `max`: with fewer, the model's error minus its doubt
/// exceeds `max_error`. The doubt covers the grid's phase and the model's omissions; see doubt() in
/// the source.
int min_segments(const GridModel& model, int sides, double max_error, int max);

/// From this number of sides on min_segments_of_many_sides() holds.
constexpr int kManySides = 64;

/// The fewest segments, up to 128, whose edges along the tube do not by themselves rule out grids
/// of kManySides and more.
int min_segments_of_many_sides(const GridModel& model, double max_error);

}  // namespace lumaknot
