#include "meshgen/lean_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <limits>

#include "math/angle.h"
#include "meshgen/deviation.h"
#include "meshgen/tube_distance.h"
#include "system/error.h"

namespace lumaknot {
namespace {

struct Knot {
  int p, q;
  double tube;
};

constexpr Knot kKnots[] = {{2, 3, 0.18}, {3, 5, 0.05}, {5, 2, 0.1}, {1, 0, 0.18}, {0, 1, 0.18}};

long long quads(int segments, int sides) { return static_cast<long long>(segments) * sides; }

long long quads(const LeanGrid& grid) { return quads(grid.segments, grid.sides); }

/// Refuses grids of a tube by points on and next to the quads' diagonals: right-angled or slightly
/// acute triangles are worst there. Begins where the last grid failed.
class Refusal {
 public:
  Refusal(const TubeSurface& surface, double max_error)
      : surface_(surface), max_(max_error * (1 + 1e-9)) {}

  bool refuses(int segments, int sides) {
    for (int k = 0; k < segments; ++k) {
      const int i = (int(where_ * segments) + k) % segments;
      if (!strip_refuses(i, segments, sides)) continue;
      where_ = (i + 0.5) / segments;
      return true;
    }
    return false;
  }

 private:
  bool strip_refuses(int i, int segments, int sides) const {
    const RingFrame a = surface_.spine().frame(ring_parameter(i, segments));
    const RingFrame b = surface_.spine().frame(ring_parameter(i + 1, segments));
    const double t = ring_parameter(i, segments), h = 2 * kPi / segments;
    const auto vertex = [&](const RingFrame& frame, int j) {
      const double theta = 2 * kPi * j / sides, r = surface_.tube_radius();
      return frame.position +
             (frame.normal * std::cos(theta) + frame.binormal * std::sin(theta)) * r;
    };
    for (int j = 0; j < sides; ++j) {
      const Vec3d diagonal = (vertex(a, j) + vertex(b, j + 1)) * 0.5;
      const Vec3d below = vertex(b, j) - diagonal, above = vertex(a, j + 1) - diagonal;
      for (const double w : {0.0, 0.02, 0.04, 0.06, 0.08}) {
        if (off(t + h * (0.5 + w / 2), diagonal + below * w)) return true;
        if (off(t + h * (0.5 - w / 2), diagonal + above * w)) return true;
      }
    }
    return false;
  }

  bool off(double t, const Vec3d& x) const {
    const Curve& curve = surface_.spine().curve();
    const double d = distance_near(curve, curve_point(curve, t), t, x);
    return std::abs(d - surface_.tube_radius()) > max_;
  }

  const TubeSurface& surface_;
  double max_;
  double where_ = 0;
};

/// Whether the grid is within the error and better than `best`.
bool beats(const TubeSurface& surface, int segments, int sides, const LeanGrid& best,
           double max_error) {
  const double chord = measured_chord(surface, segments, sides);
  return chord <= max_error && (quads(segments, sides) < quads(best) || chord < best.chord);
}

/// The number of better grids among all those with at most as many quads.
int better_grids(const TubeSurface& surface, const LeanGrid& best, double max_error) {
  std::atomic<int> better = 0;
  oneapi::tbb::parallel_for(3, int(quads(best) / 3) + 1, [&](int sides) {
    // No number of segments reduces the error of a ring's polygon.
    if (surface.tube_radius() * (1 - std::cos(kPi / sides)) > max_error * (1 + 1e-9)) return;
    Refusal refusal(surface, max_error);
    for (int segments = 3; quads(segments, sides) <= quads(best); ++segments) {
      if (refusal.refuses(segments, sides)) continue;
      if (beats(surface, segments, sides, best, max_error)) ++better;
    }
  });
  return better;
}

class LeanGridOf : public testing::TestWithParam<Knot> {
 protected:
  const Spine spine_{Curve{GetParam().p, GetParam().q}};
  const TubeSurface surface_{spine_, GetParam().tube};
};

TEST_P(LeanGridOf, meets_the_error_and_spends_it) {
  for (const double e : {1e-2, 3e-3, 1e-3, 1e-4, 1e-5}) {
    const LeanGrid grid = lean_grid(surface_, e);
    EXPECT_EQ(grid.chord, measured_chord(surface_, grid.segments, grid.sides));
    EXPECT_LE(grid.chord, e);
    EXPECT_GE(grid.chord, 0.7 * e);
  }
}

TEST_P(LeanGridOf, is_beaten_by_no_grid_at_all) {
  for (const double e : {1.0, 0.1, 1e-2, 3e-3}) {
    EXPECT_EQ(better_grids(surface_, lean_grid(surface_, e), e), 0) << e;
  }
}

TEST_P(LeanGridOf, is_beaten_by_no_grid_of_half_to_twice_the_sides) {
  for (const double e : {1e-3, 1e-4, 1e-5}) {
    const LeanGrid best = lean_grid(surface_, e);
    Refusal refusal(surface_, e);
    for (int sides = best.sides / 2; sides <= 2 * best.sides; ++sides) {
      // The maximum number of segments of a leaner grid; a twisted tube also fails with fewer.
      const int segments = int((quads(best) - 1) / sides);
      if (refusal.refuses(segments, sides)) continue;
      EXPECT_FALSE(beats(surface_, segments, sides, best, e)) << segments << " x " << sides;
    }
  }
}

std::string name_of(const testing::TestParamInfo<Knot>& knot) {
  return std::to_string(knot.param.p) + "_" + std::to_string(knot.param.q);
}

INSTANTIATE_TEST_SUITE_P(Knots, LeanGridOf, testing::ValuesIn(kKnots), name_of);

TEST(LeanGrid, of_an_error_beyond_the_knot_is_the_smallest) {
  const Spine spine{Curve{}};
  const LeanGrid grid = lean_grid({spine, 0.18}, 10);
  EXPECT_EQ(grid.segments, 3);
  EXPECT_EQ(grid.sides, 3);
}

TEST(LeanGrid, reports_its_progress) {
  const Spine spine{Curve{}};
  std::vector<double> reported;
  lean_grid({spine, 0.18}, 1e-3, [&](double share) { reported.push_back(share); });
  EXPECT_TRUE(std::ranges::is_sorted(reported));
  EXPECT_EQ(reported.front(), 0);
  EXPECT_EQ(reported.back(), 1);
}

TEST(LeanGrid, errors_name_the_value_and_the_remedy) {
  const Spine spine{Curve{}};
  const TubeSurface surface(spine, 0.18);
  const auto message = [](const std::string& text) {
    return testing::ThrowsMessage<Error>(testing::HasSubstr(text));
  };
  for (const double e : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT([&] { lean_grid(surface, e); }, message("max_error must be > 0"));
  }
  for (const double e : {1e-8, 1e-300}) {
    EXPECT_THAT([&] { lean_grid(surface, e); }, message("allow at least"));
  }
  const Spine circle{Curve{0, 1}};  // of radius 0.4
  EXPECT_THAT([&] { lean_grid({circle, 0.4}, 1e-2); }, message("make the tube thinner"));
}

}  // namespace
}  // namespace lumaknot
