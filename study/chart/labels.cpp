#include "study/chart/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "math/angle.h"

namespace lumaknot::chart {
namespace {

constexpr double kGap = 2;         // pixels between two boxes
constexpr double kPointCost = 30;  // pixels farther away rather than a marker covered
constexpr double kLineCost = 12;   // rather than a line
constexpr double kStep = 6;        // between two rings of positions
constexpr int kRings = 20, kAngles = 16;

PlaceBox grown(const PlaceBox& box, double by) {
  return {box.left - by, box.top - by, box.right + by, box.bottom + by};
}

bool is_within(const PlaceBox& box, const PlaceBox& panel) {
  return box.left >= panel.left && box.right <= panel.right && box.top >= panel.top &&
         box.bottom <= panel.bottom;
}

PlaceBox box_about(const PlacePoint& center, const PlaceLabel& label) {
  return {center.x - label.width / 2, center.y - label.height / 2, center.x + label.width / 2,
          center.y + label.height / 2};
}

double distance(const PlaceBox& box, const PlacePoint& point) {
  const PlacePoint nearest = nearest_in(box, point);
  return std::hypot(nearest.x - point.x, nearest.y - point.y);
}

/// Whether the segment meets the box: what the four sides leave of it (Liang and Barsky, 1984).
bool crosses(const PlaceSegment& line, const PlaceBox& box) {
  const double dx = line.to.x - line.from.x, dy = line.to.y - line.from.y;
  double from = 0, to = 1;
  const auto clip = [&](double towards, double room) {
    if (towards == 0) return room >= 0;
    const double t = room / towards;
    (towards < 0 ? from : to) = towards < 0 ? std::max(from, t) : std::min(to, t);
    return from <= to;
  };
  return clip(-dx, line.from.x - box.left) && clip(dx, box.right - line.from.x) &&
         clip(-dy, line.from.y - box.top) && clip(dy, box.bottom - line.from.y);
}

/// Places one label after the other.
class Placement {
 public:
  Placement(const PlaceObstacles& obstacles, const PlaceBox& panel)
      : obstacles_(obstacles), panel_(panel) {}

  PlaceBox place(const PlaceLabel& label) {
    std::optional<PlaceBox> best = best_of(around(label), label);
    if (!best) best = best_of(everywhere(label), label);
    placed_.push_back(best.value_or(box_about(label.point, label)));
    return placed_.back();
  }

 private:
  /// Boxes whose nearest side or corner is on rings about the point.
  static std::vector<PlaceBox> around(const PlaceLabel& label) {
    std::vector<PlaceBox> boxes;
    for (int ring = 0; ring < kRings; ++ring) {
      const double r = kMarker + 2 + kStep * ring;
      for (int k = 0; k < kAngles; ++k) {
        const double angle = kTurn * k / kAngles, c = std::cos(angle), s = std::sin(angle);
        boxes.push_back(box_about(
            {label.point.x + c * (r + label.width / 2), label.point.y - s * (r + label.height / 2)},
            label));
      }
    }
    return boxes;
  }

  /// Boxes side by side over the whole panel.
  std::vector<PlaceBox> everywhere(const PlaceLabel& label) const {
    std::vector<PlaceBox> boxes;
    for (double y = panel_.top; y + label.height <= panel_.bottom; y += kStep) {
      for (double x = panel_.left; x + label.width <= panel_.right; x += kStep) {
        boxes.push_back({x, y, x + label.width, y + label.height});
      }
    }
    return boxes;
  }

  std::optional<PlaceBox> best_of(const std::vector<PlaceBox>& boxes,
                                  const PlaceLabel& label) const {
    std::optional<PlaceBox> best;
    double min = std::numeric_limits<double>::infinity();
    for (const PlaceBox& box : boxes) {
      const double cost = is_free(box) ? cost_of(box, label) : min;
      if (cost >= min) continue;
      min = cost;
      best = box;
    }
    return best;
  }

  bool is_free(const PlaceBox& box) const {
    return is_within(box, panel_) && std::ranges::none_of(placed_, [&](const PlaceBox& other) {
             return grown(box, kGap).overlaps(other);
           });
  }

  double cost_of(const PlaceBox& box, const PlaceLabel& label) const {
    double cost = distance(box, label.point);
    for (const PlacePoint& point : obstacles_.points) {
      if (distance(box, point) < kMarker) cost += kPointCost;
    }
    for (const PlaceSegment& line : obstacles_.lines) {
      if (crosses(line, grown(box, 1))) cost += kLineCost;
    }
    return cost;
  }

  const PlaceObstacles& obstacles_;
  PlaceBox panel_;
  std::vector<PlaceBox> placed_;
};

}  // namespace

std::vector<PlaceBox> place_labels(std::span<const PlaceLabel> labels,
                                   const PlaceObstacles& obstacles, const PlaceBox& panel) {
  Placement placement(obstacles, panel);
  std::vector<PlaceBox> boxes;
  boxes.reserve(labels.size());
  for (const PlaceLabel& label : labels) boxes.push_back(placement.place(label));
  return boxes;
}

bool is_far_away(const PlaceBox& box, const PlacePoint& point) {
  return distance(box, point) > kMarker + 2 + kStep;
}

PlacePoint nearest_in(const PlaceBox& box, const PlacePoint& point) {
  return {std::clamp(point.x, box.left, box.right), std::clamp(point.y, box.top, box.bottom)};
}

}  // namespace lumaknot::chart
