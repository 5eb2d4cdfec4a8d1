/// The knot as a flat mesh, shared by every renderer and file format.
#pragma once

#include "meshgen/frames.h"
#include "scene/triangle_mesh.h"

namespace lumaknot {

/// The order of one component's vertices in the arrays: ring by ring, `columns` vertices per ring.
struct GridLayout {
  int segments, sides;
  int columns;  ///< sides + 1; in Babylon.js's meshes, whose last side ends at the first column,
                ///< sides

  long long vertices() const { return (segments + 1LL) * columns; }
  long long triangles() const { return 2LL * segments * sides; }
};

GridLayout layout_of(const KnotSpec& knot);

/// The centre lines as defined by the convention: components(), except that three.js and Babylon.js
/// make no links but retrace one loop.
std::vector<Curve> centre_lines(const KnotSpec& knot);

/// The tubes of the knot's components, one after the other: (segments + 1) x (sides + 1) vertices
/// each, with the first ring and the first vertex of every ring doubled to carry the texture
/// coordinates of both ends, and 2 x segments x sides triangles, wound counter-clockwise seen from
/// outside, the two halves of each quad consecutively. Positions and normals are the exact tube's
/// to rounding; u runs 0 ... repeat_u along, v 0 ... repeat_v around.
///
/// Convention kThree has three.js's vertices, normals, texture coordinates and indices. kBabylon
/// has Babylon.js's: normals averaged from faces, so that a seam shows where the ends meet, and
/// triangles wound clockwise, as in its left-handed world.
///
/// Uses all cores; only the mesh and its rings' frames are held in memory. Throws Error when the
/// numbers are out of range or exceed double precision, or frames are undefined.
TriangleMesh knot_mesh(const KnotSpec& knot);

}  // namespace lumaknot
