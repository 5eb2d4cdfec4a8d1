/// Rays against the exact round tube about curves.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "meshgen/curve.h"

namespace lumaknot::exact {

/// The points origin + s direction; the direction is not zero and need not be unit.
struct Ray {
  Vec3d origin, direction;
};

/// Where a ray meets a tube.
struct TubeHit {
  double distance = 0;    ///< s, in lengths of the ray's direction
  std::size_t curve = 0;  ///< the curve that the tube surrounds
  double t = 0;           ///< of the normal plane through the point, radians, in [0, 2 pi]
  Vec3d position;         ///< to about 1e-15 of the distance, unless the ray nearly touches
  Vec3d normal;           ///< unit, away from the curve
};

/// All hits of a ray.
struct TubeHits {
  std::vector<TubeHit> hits;  ///< nearest first
  bool decided =
      true;  ///< false: it touches within rounding, so there may be two hits more or fewer
};

/// The first hit of a ray.
struct FirstHit {
  std::optional<TubeHit> hit;
  bool decided = true;  ///< false: at the hit or before it, the ray touches within rounding
};

/// The tube of one radius about some curves, prepared for rays.
///
/// The tube is the envelope of the balls about the points C(t). With the unit direction d, let the
/// ray's foot for C(t) be its nearest point, a(t) from the foot to C(t), and D = r^2 - |a|^2. The
/// ray enters and leaves the ball at -+ sqrt(D) from the foot, and meets the tube where either is
/// stationary, that is at the roots, where D > 0, of
///   F(t) = D' / 2 -+ (d.C') sqrt(D) = (P - C).C'
/// with P the point of entry or exit. There F' = -(|C'|^2 - (P - C).C''), which is negative
/// wherever the tube is thinner than the curve bends: so on each interval where D > 0, F has one
/// root or none, depending on the signs at its ends. Where it is thicker, intervals are halved
/// until F' has one sign. D, D'' and F' are bounded by Taylor expansions with remainder, from
/// bounds of the curve's derivatives; no root between samples is missed. Undecidable intervals are
/// those where the ray touches the tube, or meets the edge of a tube thicker than the curve bends.
class TubeRays {
 public:
  /// Each curve's minor radius and `radius` must be > 0.
  TubeRays(std::span<const Curve> curves, double radius);

  TubeHits all(const Ray& ray) const;

  /// The nearest hit with distance > `beyond`, and whether there is one.
  FirstHit first(const Ray& ray, double beyond = 0) const;

  /// An interval of a curve: its ends and its middle, and bounds of the derivatives on it.
  struct Segment {
    std::size_t curve = 0;
    double from = 0, to = 0;  ///< t
    CurvePoint start, middle, end;
    double first = 0, second = 0, third = 0;  ///< |C'|, |C''|, |C'''| at most
    bool thin = false;                        ///< F' < 0 whatever the ray

    double half() const { return (to - from) / 2; }
  };

 private:
  /// A ball around the curves' pieces [first, last); its halves are the balls `left` and left + 1.
  struct Ball {
    Vec3d center;
    double radius = 0;
    std::size_t first = 0, last = 0, left = 0;
  };
  class Search;

  void fill(std::size_t ball, std::size_t first, std::size_t last);

  std::vector<Curve> curves_;
  double radius_;
  std::vector<Segment> pieces_;
  std::vector<Ball> balls_;
};

}  // namespace lumaknot::exact
