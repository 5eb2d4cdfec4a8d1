#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "meshgen/knot_mesh.h"
#include "system/error.h"

namespace lumaknot {
namespace {

KnotSpec scaled_knot(double scale) {
  KnotSpec knot;
  knot.major_radius *= scale;
  knot.minor_radius *= scale;
  knot.tube_radius *= scale;
  knot.segments = 120;
  knot.sides = 12;
  return knot;
}

TEST(ExtremeLengths, a_knot_of_another_size_is_the_same_knot) {
  const TriangleMesh reference = knot_mesh(scaled_knot(1));
  for (const double scale : {1e-30, 1e-3, 1e6, 1e30}) {
    const TriangleMesh mesh = knot_mesh(scaled_knot(scale));
    ASSERT_EQ(mesh.positions.size(), reference.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      // Rounding, which accumulates over 120 steps of the frame.
      ASSERT_LT(length(mesh.positions[i] / scale - reference.positions[i]), 1e-12) << scale;
      ASSERT_LT(length(mesh.normals[i] - reference.normals[i]), 1e-12) << scale;
    }
  }
}

TEST(ExtremeLengths, a_knot_has_unit_normals_or_is_an_error) {
  for (int exponent = -320; exponent <= 308; exponent += 4) {
    const double scale = std::pow(10.0, exponent);
    if (!(scaled_knot(scale).tube_radius > 0)) continue;
    try {
      const TriangleMesh mesh = knot_mesh(scaled_knot(scale));
      for (const Vec3d& normal : mesh.normals) {
        ASSERT_NEAR(length(normal), 1, 1e-9) << "lengths of about 1e" << exponent;
      }
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("nearer to 1"));
    }
  }
}

TEST(ExtremeLengths, beyond_double_precision_is_an_error_that_quotes_them) {
  for (const double scale : {1e300, 1e-300}) {
    try {
      knot_mesh(scaled_knot(scale));
      ADD_FAILURE() << "a knot of size " << scale << " was built";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(scale > 1 ? "e+300" : "e-300"));
      EXPECT_THAT(error.what(), testing::HasSubstr("nearer to 1"));
    }
  }
}

TEST(ExtremeLengths, one_huge_length_among_ordinary_ones_is_drawn_or_refused) {
  for (double KnotSpec::* field :
       {&KnotSpec::major_radius, &KnotSpec::minor_radius, &KnotSpec::tube_radius}) {
    for (const double value : {1e200, 1e300}) {
      KnotSpec knot = scaled_knot(1);
      knot.*field = value;
      try {
        const TriangleMesh mesh = knot_mesh(knot);
        for (const Vec3d& normal : mesh.normals) ASSERT_NEAR(length(normal), 1, 1e-9) << value;
      } catch (const Error& error) {
        // A tube beyond the ring is refused as such.
        EXPECT_THAT(error.what(), testing::AnyOf(testing::HasSubstr("nearer to 1"),
                                                 testing::HasSubstr("mesh.knot.tube must be <")));
      }
    }
  }
}

TEST(ExtremeLengths, a_tube_too_thin_for_the_ring_is_drawn_or_refused) {
  for (const double tube : {1e-12, 1e-18, 1e-300}) {
    KnotSpec knot = scaled_knot(1);
    knot.tube_radius = tube;
    try {
      const TriangleMesh mesh = knot_mesh(knot);
      for (int ring = 0; ring < knot.segments; ++ring) {
        const auto at = [&](int side) {
          return mesh
              .positions[std::size_t(ring) * std::size_t(knot.sides + 1) + std::size_t(side)];
        };
        // Rounding of positions near one is 1e-16: 1e-4 of the thinnest tube that can be drawn.
        ASSERT_NEAR(length(at(0) - at(6)) / (2 * tube), 1, 1e-2) << tube;
      }
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("nearer to 1"));
    }
  }
}

}  // namespace
}  // namespace lumaknot
