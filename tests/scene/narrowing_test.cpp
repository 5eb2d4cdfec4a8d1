#include <gtest/gtest.h>

#include "math/vec.h"

namespace lumaknot {
namespace {

Vec3d narrowed(const Vec3d& v) { return {float(v.x), float(v.y), float(v.z)}; }

// GCC 12.2 left x and y unchanged unless told not to merge neighbouring operations.
TEST(Narrowing, of_neighbouring_doubles_rounds_each) {
  volatile double tenth = 0.1;
  const double x = tenth;
  const Vec3d v = narrowed({x, 2 * x, 3 * x});
  EXPECT_EQ(v.x, 0.10000000149011612);
  EXPECT_EQ(v.y, 0.20000000298023224);
  EXPECT_EQ(v.z, double(float(0.30000000000000004)));
}

}  // namespace
}  // namespace lumaknot
