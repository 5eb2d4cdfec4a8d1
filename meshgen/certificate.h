/// What is true of a knot's mesh, measured on the mesh and beside it what is true of the exact
/// tube.
#pragma once

#include <optional>

#include "meshgen/clearance.h"
#include "meshgen/deviation.h"
#include "meshgen/knot_mesh.h"
#include "meshgen/measure.h"

namespace lumaknot {

/// A range of measured values.
struct Range {
  double least = 0, most = 0;
};

/// How much longer than on average a texture is drawn, at its most and its least: 1 is everywhere
/// the same.
struct Stretch {
  Range along;    ///< lengths of the centre line a unit of u
  Range surface;  ///< lengths of edges along, by the exact centre line's average
  Range around;   ///< lengths of edges around, by the exact circle's
};

/// Lengths in scene units, angles in degrees.
struct Certificate {
  std::vector<Piece> pieces;      ///< of the mesh with its seams sewn, one a component
  std::size_t file_vertices = 0;  ///< with the seams' duplicates
  double volume = 0,
         exact_volume = 0;          ///< Pappus: pi r^2 times the length; negative when clockwise
  double area = 0, exact_area = 0;  ///< 2 pi r times the length
  double length = 0;                ///< of all components' centre lines
  double holonomy = 0;       ///< by which a frame that twists least misses itself after a loop
  double twist = 0;          ///< of the mesh's frames against one that twists least, in one loop
  double closing_error = 0;  ///< between the first ring's frame and the one after the last
  double ring_tilt = 0;      ///< the largest between a ring's plane and the plane across the line
  Clearance clearance;       ///< the largest tube and what limits it
  Deviation measured;        ///< of the first component; the others are congruent
  std::optional<Deviation> bound;  ///< of exact rings alone, as KnotSpec's defaults have them
  Stretch stretch;
};

/// Measures `mesh`, which knot_mesh() made of `knot`. Normals of rings that are not exact are
/// measured at the vertices alone. Needs some 350 bytes a vertex.
Certificate certify(const KnotSpec& knot, const TriangleMesh& mesh);

}  // namespace lumaknot
