/// What the truth shows near a pixel.
#pragma once

#include <cstdint>

#include "render/exact_pixels.h"
#include "scene/image.h"
#include "study/planning/tolerance.h"

namespace lumaknot {

/// Where on the exact surface a point lies: a component and its parameters, or -1 for nowhere.
struct SeenPlace {
  std::int64_t component = -1;
  double t = 0, theta = 0;  ///< radians
};

SeenPlace place_of(const ExactFragment& seen);

/// Whether both show one smooth piece of the surface, or both nothing, as neighbours do away from
/// edges: not too far apart in t and theta.
bool on_one_piece(const SeenPlace& a, const SeenPlace& b);

/// The least and the most of each channel, colours limited to [0, 1].
struct SampleRange {
  Sample low, high;

  /// Takes in a sample that is known to within `error`: what is certain of it.
  void add(const Sample& sample, double error);

  /// How far the worst channel of `sample` lies outside. Infinite for what is no number.
  double distance(const Sample& sample) const;
};

/// What one pixel may show, as far as it was looked at. Each holds the one before.
struct NearbyRange {
  SampleRange place;   ///< of the very place
  SampleRange coarse;  ///< of the fewest cells; of point truth the place
  SampleRange quick;   ///< of a few rays or cells
  SampleRange full;    ///< of many
  SampleRange behind;  ///< and of what is hidden by less than the shift
  bool has_coarse = false, has_quick = false, has_full = false;
};

/// How deep a straight way leads into a round tube, at its deepest: the tube's radius minus the
/// way's least distance from the centre line. `through` leads from where it goes in to where it
/// comes out, `normal` is the surface's at either. Exact where the centre line is straight.
double passage_depth(const Vec3d& through, const Vec3d& normal, double tube_radius);

/// Looks at the truth about pixels: first quickly, then fully. Of point truth: eight directions at
/// the shift, eight at half of it; then at eight distances in thirty-two directions and on both
/// sides of every edge between them. Of area truth: n x n cells of the pixel, n = 8, 16, then 32,
/// each with the rays to cells so near that they are within the shift of all its points; the means
/// of the cells' least and most. All see less than there is: what lies in the range is certainly
/// near.
///
/// A surface that is off by a hair has its horizon elsewhere, and shows what lies just beyond. So
/// where a ray of the full look passes through the tube no deeper than what its own distance from
/// the pixel's centre leaves of the shift, what it meets next counts as well; it is kept apart.
class Nearby {
 public:
  /// Keeps `pixels` by reference; the tube's radius is in scene units.
  Nearby(const ExactPixels& pixels, double tube_radius, double shift, bool area)
      : pixels_(pixels), tube_radius_(tube_radius), shift_(shift), area_(area) {}

  /// Fills `coarse`, `quick`, or `full` and `behind`, of the pixel (x, y), unless they are there.
  void look_coarsely(NearbyRange& nearby, int x, int y) const;
  void look_quickly(NearbyRange& nearby, int x, int y) const;
  void look_fully(NearbyRange& nearby, int x, int y) const;

 private:
  void look_at_cells(SampleRange& range, int x, int y, int cells) const;
  void look_around(SampleRange& range, double x, double y) const;
  void look_closely(NearbyRange& nearby, double x, double y) const;
  void look_behind(SampleRange& range, Vec2d at, double depth, const ExactFragment& seen) const;
  void look_at_edge(SampleRange& range, Vec2d seen, Vec2d other) const;

  const ExactPixels& pixels_;
  double tube_radius_, shift_;
  bool area_;
};

}  // namespace lumaknot
