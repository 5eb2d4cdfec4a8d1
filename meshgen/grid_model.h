/// A smooth model of how far a grid's triangles are off, that leads the search of lean_grid.h.
#pragma once

#include <vector>

#include "meshgen/surface.h"

namespace lumaknot {

/// Where the surface bends most along the tube, and how much.
struct Peak {
  double t, bulge;
};

/// A point where a grid is likely to be worst, in radians.
struct Witness {
  double t, theta;
};

/// What the search knows of a tube.
struct GridModel {
  const TubeSurface& surface;
  Peak peak;         ///< the highest
  double turning;    ///< s K there: the centre line's angle a radian of t
  double twist;      ///< -X_tk . n = r s w there
  double sharpness;  ///< the largest curvature of the centre line
  std::vector<Witness> witnesses;
};

GridModel grid_model(const TubeSurface& surface);

/// The error of a ring's own polygon, which no number of segments mends: exact, since an edge's
/// midpoint lies in the ring's plane, which is normal to the centre line.
double ring_error(const GridModel& model, int sides);

/// The fewest sides, 3 or more, whose rings meet the error.
int least_sides(const GridModel& model, double max_error);

/// The fewest segments worth a trial, 3 ... `most`: of fewer the model's error without its doubt is
/// beyond `max_error`. The doubt is what the grid's phase can hide and the model leaves out; see
/// doubt() in the source.
int least_segments(const GridModel& model, int sides, double max_error, int most);

/// From so many sides on least_segments_of_many_sides() holds.
constexpr int kManySides = 64;

/// The fewest segments, up to 128, whose edges along the tube do not alone forbid grids of
/// kManySides and more.
int least_segments_of_many_sides(const GridModel& model, double max_error);

}  // namespace lumaknot
