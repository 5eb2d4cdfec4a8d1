/// Properties of a knot's mesh, measured on the mesh and compared with the exact tube's.
#pragma once

#include <optional>

#include "math/interval.h"
#include "meshgen/clearance.h"
#include "meshgen/deviation.h"
#include "meshgen/knot_mesh.h"
#include "meshgen/measure.h"

namespace lumaknot {

/// How far a texture is stretched relative to the average, at its minimum and maximum: 1 is
/// uniform.
struct Stretch {
  Interval<double> along;  ///< lengths of the centre line per unit of u
  Interval<double>
      surface;              ///< lengths of edges along, relative to the exact centre line's average
  Interval<double> around;  ///< lengths of edges around, relative to the exact circle's
};

/// Lengths in scene units, angles in degrees.
struct Certificate {
  std::vector<ConnectedComponent>
      connected_components;       ///< of the mesh with its seams sewn, one per component
  std::size_t file_vertices = 0;  ///< with the seams' duplicates
  double volume = 0,
         exact_volume = 0;          ///< Pappus: pi r^2 times the length; negative when clockwise
  double area = 0, exact_area = 0;  ///< 2 pi r times the length
  double length = 0;                ///< of all components' centre lines
  double holonomy =
      0;             ///< the angle by which a frame of minimal twist fails to close after one loop
  double twist = 0;  ///< of the mesh's frames relative to a frame of minimal twist, in one loop
  double closing_error = 0;  ///< between the first ring's frame and the one after the last
  double ring_tilt =
      0;  ///< the largest angle between a ring's plane and the plane normal to the line
  Clearance clearance;             ///< the largest tube and what limits it
  Deviation measured;              ///< of the first component; the others are congruent
  std::optional<Deviation> bound;  ///< for exact rings only, KnotSpec's default
  Stretch stretch;
};

/// Measures `mesh`, which knot_mesh() built from `knot`. Normals of rings that are not exact are
/// measured at the vertices only. Needs about 350 bytes per vertex.
Certificate certify(const KnotSpec& knot, const TriangleMesh& mesh);

}  // namespace lumaknot
