#include "scene/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "scene/presets.h"
#include "tests/scene/error_of.h"

namespace lumaknot {
namespace {

using testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string knot_refusal(const KnotSpec& knot, const std::string& prefix) {
  return error_of([&] { check_knot(knot, prefix); });
}

TEST(CheckInteger, accepts_the_ends_of_its_range_and_nothing_beyond) {
  EXPECT_NO_THROW(check_integer("--n", 3, {3, 5}));
  EXPECT_NO_THROW(check_integer("--n", 5, {3, 5}));
  EXPECT_EQ(error_of([] { check_integer("--n", 2, {3, 5}); }),
            "--n must be an integer from 3 to 5, got 2");
  EXPECT_EQ(error_of([] { check_integer("--n", 4294967300, {3, 5}); }),
            "--n must be an integer from 3 to 5, got 4294967300");
}

TEST(CheckNumber, distinguishes_open_ends_from_closed_ones) {
  const Interval<double> closed{.min = 0, .max = 1},
      open{.min = 0, .max = 1, .open_min = true, .open_max = true};
  EXPECT_NO_THROW(check_number("x", 0, closed));
  EXPECT_NO_THROW(check_number("x", 1, closed));
  EXPECT_NO_THROW(check_number("x", 0.5, open));
  EXPECT_EQ(error_of([&] { check_number("x", 0, open); }), "x must be > 0, got 0");
  EXPECT_EQ(error_of([&] { check_number("x", 1, open); }), "x must be < 1, got 1");
  EXPECT_EQ(error_of([&] { check_number("x", -1, closed); }), "x must be >= 0, got -1");
  EXPECT_EQ(error_of([&] { check_number("x", 2, closed); }), "x must be <= 1, got 2");
}

TEST(CheckNumber, refuses_what_is_not_finite_whatever_the_bound) {
  for (const double value : {kInfinity, -kInfinity, kNaN}) {
    EXPECT_THAT(error_of([&] { check_number("x", value, {}); }), HasSubstr("finite"));
  }
  EXPECT_NO_THROW(check_number("x", std::numeric_limits<double>::max(), {}));
  EXPECT_NO_THROW(check_number("x", std::numeric_limits<double>::lowest(), {}));
}

TEST(CheckKnot, accepts_every_pair_except_zero_and_zero) {
  KnotSpec knot;
  for (const auto& [p, q] : {std::pair{1, 0},
                             {0, 1},
                             {-1, 0},
                             {1, 1},
                             {-2, 3},
                             {999, 1000},
                             {2, 0},
                             {0, -3},
                             {2, 4},
                             {-3, 9},
                             {1000, 10}}) {
    knot.p = p;
    knot.q = q;
    EXPECT_EQ(knot_refusal(knot, ""), "") << p << "," << q;
  }
  knot.p = knot.q = 0;
  EXPECT_EQ(knot_refusal(knot, "--"), "--p and --q must not both be 0; try 2 and 3");
}

TEST(CheckKnot, refuses_a_tube_as_thick_as_the_ring) {
  KnotSpec knot;
  knot.tube_radius = 1;
  EXPECT_EQ(knot_refusal(knot, "--"), "--tube must be < --ring, 1, got 1");
}

TEST(CheckKnot, refuses_what_a_convention_does_not_support) {
  KnotSpec three = knot_defaults(Convention::kThree);
  EXPECT_EQ(knot_refusal(three, "--"), "");
  three.minor_radius = 0.4;
  EXPECT_THAT(knot_refusal(three, "--"), HasSubstr("--winding must be half of --ring"));
  three = knot_defaults(Convention::kThree);
  three.p = 0;
  EXPECT_THAT(knot_refusal(three, "--"), HasSubstr("--p must not be 0 in convention three"));
  three = knot_defaults(Convention::kThree);
  three.frames = FrameRule::kFrenet;
  EXPECT_THAT(knot_refusal(three, "--"), HasSubstr("--frames"));
  KnotSpec babylon = knot_defaults(Convention::kBabylon);
  babylon.q = 0;
  EXPECT_THAT(knot_refusal(babylon, "--"), HasSubstr("takes 0 as 3"));
}

TEST(CheckKnot, counts_the_vertices_of_every_component) {
  KnotSpec knot;
  knot.segments = 9999;
  knot.sides = 4999;  // 10,000 x 5000, half of the maximum
  knot.p = knot.q = 2;
  EXPECT_EQ(knot_refusal(knot, ""), "");
  knot.p = knot.q = 3;
  EXPECT_THAT(knot_refusal(knot, ""), HasSubstr("150000000 vertices"));
}

TEST(CheckKnot, calls_fields_by_the_prefix_it_is_given) {
  KnotSpec knot;
  knot.repeat_u = 0;
  EXPECT_THAT(knot_refusal(knot, "mesh.knot."), HasSubstr("mesh.knot.repeat_u must"));
  EXPECT_THAT(knot_refusal(knot, "--"), HasSubstr("--repeat-u must"));
}

TEST(CheckKnot, refuses_lengths_that_are_not_positive_and_finite) {
  for (double KnotSpec::* field :
       {&KnotSpec::major_radius, &KnotSpec::minor_radius, &KnotSpec::tube_radius}) {
    for (const double value : {0.0, -1.0, kInfinity, kNaN}) {
      KnotSpec knot;
      knot.*field = value;
      EXPECT_NE(knot_refusal(knot, ""), "") << value;
    }
  }
}

TEST(CheckKnot, counts_the_flat_mesh_s_vertices) {
  KnotSpec knot;
  knot.segments = 24'999;
  knot.sides = 3999;  // 25,000 x 4000: the maximum
  EXPECT_EQ(knot_refusal(knot, ""), "");
  knot.sides = 4000;
  EXPECT_THAT(knot_refusal(knot, "--"), HasSubstr("100025000"));
}

TEST(CheckSamples, counts_in_64_bits) {
  const ImageSpec image{65'536, 65'536, 64};  // 2^44 samples
  EXPECT_NO_THROW(check_samples(image, 1LL << 44));
  EXPECT_THAT(error_of([&] { check_samples(image, (1LL << 44) - 1); }),
              HasSubstr("17592186044416"));
}

TEST(CheckScene, accepts_the_default_scene) { EXPECT_NO_THROW(check_scene({})); }

TEST(CheckScene, accepts_a_line_of_sight_close_to_up) {
  SceneSpec scene;
  scene.view.camera = {{0, 1e-3, 5}, {0, 0, 0}, {0, 0, 1}, 45};
  EXPECT_NO_THROW(check_scene(scene));
}

TEST(CheckScene, ignores_the_length_of_up) {
  SceneSpec scene;
  for (const double scale : {1e-100, 1.0, 1e100}) {
    scene.view.camera.up = Vec3d{0, 0, 1} * scale;
    EXPECT_NO_THROW(check_scene(scene)) << scale;
  }
}

TEST(CheckScene, ignores_the_knot_when_the_mesh_is_a_file) {
  SceneSpec scene;
  scene.mesh = MeshFile{"a.obj"};
  EXPECT_NO_THROW(check_scene(scene));
}

}  // namespace
}  // namespace lumaknot
