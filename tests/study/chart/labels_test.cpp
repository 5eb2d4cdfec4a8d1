// Labels of points at random places, and of those that lie on each other.
#include "study/chart/labels.h"

#include <gtest/gtest.h>

#include <random>

namespace lumaknot::chart {
namespace {

constexpr PlaceBox kPanelBox{80, 100, 630, 570};

void expect_apart(const std::vector<PlaceBox>& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].left, kPanelBox.left);
    EXPECT_GE(boxes[i].top, kPanelBox.top);
    EXPECT_LE(boxes[i].right, kPanelBox.right);
    EXPECT_LE(boxes[i].bottom, kPanelBox.bottom);
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(boxes[i].overlaps(boxes[k])) << i << " " << k;
  }
}

TEST(Labels, at_random_points_never_overlap_and_stay_in_the_panel) {
  std::mt19937 random(1);
  const auto at = [&](double from, double to) {
    return from + (to - from) * double(random()) / double(std::mt19937::max());
  };
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<PlaceLabel> labels;
    PlaceObstacles obstacles;
    for (int i = 0; i < 30; ++i) {
      const PlacePoint point{at(kPanelBox.left, kPanelBox.right),
                             at(kPanelBox.top, kPanelBox.bottom)};
      labels.push_back({point, at(8, 70), 13});
      obstacles.points.push_back(point);
    }
    expect_apart(place_labels(labels, obstacles, kPanelBox));
  }
}

TEST(Labels, of_points_on_one_spot_never_overlap) {
  const std::vector<PlaceLabel> labels(40, PlaceLabel{{300, 300}, 60, 13});
  expect_apart(place_labels(labels, {{{300, 300}}, {}}, kPanelBox));
}

TEST(Labels, in_a_corner_stay_in_the_panel) {
  const std::vector<PlaceLabel> labels(9, PlaceLabel{{80, 570}, 60, 13});
  expect_apart(place_labels(labels, {}, kPanelBox));
}

TEST(Labels, of_a_point_alone_are_beside_it) {
  const PlacePoint point{300, 300};
  const PlaceBox box = place_labels(std::vector<PlaceLabel>{{point, 60, 13}}, {}, kPanelBox)[0];
  EXPECT_FALSE(is_far_away(box, point));
  EXPECT_EQ(box.width(), 60);
}

TEST(Labels, keep_off_markers_and_lines_where_there_is_room) {
  const PlacePoint point{300, 300};
  const PlaceObstacles obstacles{{point, {330, 300}, {270, 300}, {300, 285}},
                                 {{{300, 300}, {340, 340}}}};
  const PlaceBox box =
      place_labels(std::vector<PlaceLabel>{{point, 40, 13}}, obstacles, kPanelBox)[0];
  for (const PlacePoint& p : obstacles.points) {
    const PlacePoint nearest = nearest_in(box, p);
    EXPECT_GE(std::hypot(nearest.x - p.x, nearest.y - p.y), kMarker);
  }
  for (int k = 0; k <= 40; ++k) {  // points of the line
    const PlacePoint nearest = nearest_in(box, {300.0 + k, 300.0 + k});
    EXPECT_GT(std::hypot(nearest.x - 300 - k, nearest.y - 300 - k), 0);
  }
}

TEST(Labels, are_the_same_for_the_same_points) {
  const std::vector<PlaceLabel> labels{{{100, 200}, 50, 13}, {{104, 203}, 50, 13}};
  const PlaceObstacles obstacles{{{100, 200}, {104, 203}}, {}};
  EXPECT_EQ(place_labels(labels, obstacles, kPanelBox), place_labels(labels, obstacles, kPanelBox));
}

}  // namespace
}  // namespace lumaknot::chart
