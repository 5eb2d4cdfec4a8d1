/// Where the labels of a picture's points go.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace lumaknot::chart {

/// In pixels, y downwards.
struct PlacePoint {
  double x = 0, y = 0;
};

struct PlaceBox {
  double left = 0, top = 0, right = 0, bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  PlacePoint center() const { return {(left + right) / 2, (top + bottom) / 2}; }
  bool overlaps(const PlaceBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  friend bool operator==(const PlaceBox&, const PlaceBox&) = default;
};

struct PlaceSegment {
  PlacePoint from, to;
};

/// A text of that size at a point.
struct PlaceLabel {
  PlacePoint point;
  double width = 0, height = 0;
};

/// What labels had better not cover.
struct PlaceObstacles {
  std::vector<PlacePoint> points;  ///< markers of kMarker pixels in radius
  std::vector<PlaceSegment> lines;
};

inline constexpr double kMarker = 5;

/// A box in `panel` for each label, in their order: of the positions around the label's point, the
/// nearest that covers the fewest obstacles and no box before it. No two boxes overlap as long as
/// the panel has room. The same for the same input.
std::vector<PlaceBox> place_labels(std::span<const PlaceLabel> labels,
                                   const PlaceObstacles& obstacles, const PlaceBox& panel);

/// Whether a line is needed to see which point a label belongs to.
bool is_far_away(const PlaceBox& box, const PlacePoint& point);

/// The point of the box nearest to `point`.
PlacePoint nearest_in(const PlaceBox& box, const PlacePoint& point);

}  // namespace lumaknot::chart
