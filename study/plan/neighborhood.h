/// The truth near a pixel.
#pragma once

#include <cstdint>

#include "render/exact/pixels.h"
#include "scene/image.h"
#include "study/plan/tolerance.h"

namespace lumaknot::plan {

/// A point's place on the exact surface: a component and its parameters, or -1 for nowhere.
struct SeenPlace {
  std::int64_t component = -1;
  double t = 0, theta = 0;  ///< radians
};

SeenPlace place_of(const exact::ExactFragment& seen);

/// Whether both are on one smooth piece of the surface, or both on none, as neighbours away from
/// edges are: not too far apart in t and theta.
bool on_one_piece(const SeenPlace& a, const SeenPlace& b);

/// The range of each channel, colours limited to [0, 1].
struct SampleRange {
  exact::Sample low, high;

  /// Extends the range by what is certain of a sample known to within `error`.
  void add(const exact::Sample& sample, double error);

  /// How far the worst channel of `sample` is outside. Infinite for what is not a number.
  double distance(const exact::Sample& sample) const;
};

/// What one pixel may show, as far as it was examined. Each range contains the one before.
struct NeighborhoodRange {
  SampleRange place;   ///< of the exact place
  SampleRange coarse;  ///< of the fewest cells; of point truth the place
  SampleRange quick;   ///< of a few rays or cells
  SampleRange full;    ///< of many
  SampleRange behind;  ///< and of what less than the shift hides
  bool has_coarse = false, has_quick = false, has_full = false;
};

/// The depth of a straight line in a round tube, at its deepest: the tube's radius minus the line's
/// smallest distance from the centre line. `through` leads from its entry to its exit, `normal` is
/// the surface's at either. Exact if the centre line is straight.
double passage_depth(const Vec3d& through, const Vec3d& normal, double tube_radius);

/// Examines the truth around pixels: first quickly, then fully. Of point truth: eight directions at
/// the shift, eight at half of it; then at eight distances in thirty-two directions and on both
/// sides of every edge between them. Of area truth: n x n cells of the pixel, n = 8, 16, then 32,
/// each with the rays to cells so near that they are within the shift of all its points; the means
/// of the cells' minima and maxima. All see less than there is: what is in the range is certainly
/// near.
///
/// A surface that is slightly off has its horizon elsewhere, and shows what is just behind it. So
/// if a ray of the full look passes through the tube no deeper than the shift minus its own
/// distance from the pixel's centre, what it meets next counts as well; it is kept separately.
class PixelNeighborhood {
 public:
  /// Keeps `pixels` by reference; the tube's radius is in scene units.
  PixelNeighborhood(const exact::ExactPixels& pixels, double tube_radius, double shift, bool area)
      : pixels_(pixels), tube_radius_(tube_radius), shift_(shift), area_(area) {}

  /// Fills `coarse`, `quick`, or `full` and `behind`, of the pixel (x, y), unless they are filled.
  void look_coarsely(NeighborhoodRange& neighborhood, int x, int y) const;
  void look_quickly(NeighborhoodRange& neighborhood, int x, int y) const;
  void look_fully(NeighborhoodRange& neighborhood, int x, int y) const;

 private:
  void look_at_cells(SampleRange& range, int x, int y, int cells) const;
  void look_around(SampleRange& range, double x, double y) const;
  void look_closely(NeighborhoodRange& neighborhood, double x, double y) const;
  void look_behind(SampleRange& range, Vec2d at, double depth,
                   const exact::ExactFragment& seen) const;
  void look_at_edge(SampleRange& range, Vec2d seen, Vec2d other) const;

  const exact::ExactPixels& pixels_;
  double tube_radius_, shift_;
  bool area_;
};

}  // namespace lumaknot::plan
