/// What the truth shows near a pixel.
#pragma once

#include "render/exact_pixels.h"
#include "scene/image.h"
#include "study/planning/tolerance.h"

namespace lumaknot {

/// The least and the most of each channel, colours limited to [0, 1].
struct SampleRange {
  Sample low, high;

  /// Takes in a sample that is known to within `error`: what is certain of it.
  void add(const Sample& sample, double error);

  /// How far the worst channel of `sample` lies outside. Infinite for what is no number.
  double distance(const Sample& sample) const;
};

/// The range of one pixel, as far as it was looked at.
struct NearbyRange {
  SampleRange range;   ///< of what is seen
  SampleRange behind;  ///< and of what is hidden by less than the shift
  int looked = 0;      ///< steps
};

/// Looks at the truth about pixels, step by step: eight directions at the shift, eight at half of
/// it; then, of point truth, at four distances in sixteen directions and on both sides of every
/// edge between them; of area truth, the eight directions once more, closer to the truth. A range
/// of some samples is narrower than the whole one: what lies in it is certainly near.
///
/// A surface that is off by a hair has its horizon elsewhere, and shows what lies just beyond. So
/// where a ray of the last step passes through the tube no deeper than the shift, what it meets
/// next counts as well; it is kept apart.
class Nearby {
 public:
  /// Keeps `pixels` by reference. The means over pixels, with `area`, are known to `fine`.
  Nearby(const ExactPixels& pixels, double shift, bool area, double fine)
      : pixels_(pixels), shift_(shift), area_(area), fine_(fine) {}

  /// Steps that are cheap, and with those that are not.
  int quick_steps() const { return shift_ > 0 ? 16 : 0; }
  int all_steps() const { return shift_ > 0 ? (area_ ? 32 : 17) : 0; }

  /// The next step about the pixel (x, y).
  void widen(NearbyRange& nearby, int x, int y) const;

 private:
  void look(SampleRange& range, double x, double y, double coarse) const;
  void look_closely(NearbyRange& nearby, double x, double y) const;
  void look_behind(SampleRange& range, Vec2d at, const ExactFragment& seen) const;
  void look_at_edge(SampleRange& range, Vec2d seen, Vec2d other) const;

  const ExactPixels& pixels_;
  double shift_;
  bool area_;
  double fine_;
};

}  // namespace lumaknot
