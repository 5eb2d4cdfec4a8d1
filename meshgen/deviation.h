/// The deviation of flat triangles from the exact tube.
#pragma once

#include <span>

#include "meshgen/surface.h"

namespace lumaknot {

/// The deviation of a grid's flat triangles from the exact tube.
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
/// where a quadratic surface would be worst, and the 32 worst are maximised from there. Never above
/// the true value, and below it by at most 1e-6 of it (2e-8 where measured against 1,500 triangles
/// maximised to the end), plus the rounding of the vertices, about 1e-15 of the curve's extent. The
/// error is larger only where steps are so coarse (half a radian: 1e-4) that a triangle has several
/// worst places. Where the tube is thicker than the curve's radius of curvature, its own points are
/// nearer to the curve than r, and the chord includes that difference.
Deviation measured_deviation(const TubeSurface& surface, int segments, int sides);

/// The same for given vertices, (segments + 1) x (sides + 1) row by row, both seams doubled, which
/// need not lie on the tube; normals of any nonzero length. A circle's many equal strips can hide
/// 1e-4 of the angle from the list of the worst. Throws Error when the counts differ.
Deviation measured_deviation(const TubeSurface& surface, int segments, int sides,
                             std::span<const Vec3d> positions, std::span<const Vec3d> normals);

/// The chord alone, in about three quarters of the time.
double measured_chord(const TubeSurface& surface, int segments, int sides);

/// Bounds of Deviation's members, and of the distance between a triangle's point and the tube's
/// point at the same (t, theta): how far the surface, including its texture, is displaced.
struct DeviationBound : Deviation {
  double offset = 0;  ///< scene units, at least `chord`
};

/// An upper bound of measured_deviation() from the derivatives alone, without the triangles, after
/// Filip, Magedson, Markot: Surface algorithms using bounds on derivatives, 1986. It holds for
/// tubes that do not touch themselves. Over fifty (p,q) at 768 x 40 the chord's bound is at most
/// 1.4 times the measured value, the angle's 2.7 times; both ratios approach 1 as the steps shrink.
/// Steps of a radian make it useless: the chord's bound is then the extent, and the angle's 180
/// degrees.
DeviationBound deviation_bound(const TubeSurface& surface, int segments, int sides);

}  // namespace lumaknot
