/// How far flat triangles are from the exact tube.
#pragma once

#include <span>

#include "meshgen/surface.h"

namespace lumaknot {

/// How far a grid's flat triangles are from the exact tube.
struct Deviation {
  /// The largest |distance to the centre line - r| over all points of all triangles, in scene
  /// units. The distance is to the branch that the point's own parameter lies on.
  double chord = 0;
  /// The largest angle between the interpolated, normalised vertex normal and the tube's normal
  /// at the same (t, theta).
  double normal_degrees = 0;
};

/// The deviation of the grid whose vertex (i, j) is X(ring_parameter(i, segments), 2 pi j / sides),
/// segments and sides >= 3, quads cut from (i, j) to (i + 1, j + 1). Every triangle is evaluated
/// where a quadratic surface would be worst, and the 32 worst are maximised from there on. Never
/// above the truth, and below it by 1e-6 of it at most (2e-8 where measured against 1,500 triangles
/// maximised to the end), besides the rounding of the vertices, some 1e-15 of the curve's extent.
/// By more only where steps are so coarse (half a radian: 1e-4) that a triangle has several worst
/// places. Where the tube is thicker than the curve's radius of curvature, its own points are
/// nearer to the curve than r, and the chord says by how much.
Deviation measured_deviation(const TubeSurface& surface, int segments, int sides);

/// The same of given vertices, (segments + 1) x (sides + 1) row by row, both seams doubled, which
/// need not lie on the tube; normals of any length but zero. A circle's many equal strips can hide
/// 1e-4 of the angle from the list of the worst. Throws Error when the counts differ.
Deviation measured_deviation(const TubeSurface& surface, int segments, int sides,
                             std::span<const Vec3d> positions, std::span<const Vec3d> normals);

/// The chord alone, in some three quarters of the time.
double measured_chord(const TubeSurface& surface, int segments, int sides);

/// Bounds of what Deviation tells, and of the distance between a triangle's point and the tube's
/// point at the same (t, theta): how far the surface, its texture included, is out of place.
struct DeviationBound : Deviation {
  double offset = 0;  ///< scene units, at least `chord`
};

/// An upper bound of measured_deviation() from the derivatives alone, without the triangles, after
/// Filip, Magedson, Markot: Surface algorithms using bounds on derivatives, 1986. It holds of tubes
/// that do not touch themselves. Over fifty (p,q) at 768 x 40 the chord's bound is at most 1.4
/// times what is measured, the angle's 2.7 times; both come down to it as the steps do. Steps of a
/// radian make it useless: the chord's is then the extent, and the angle's 180 degrees.
DeviationBound deviation_bound(const TubeSurface& surface, int segments, int sides);

}  // namespace lumaknot
