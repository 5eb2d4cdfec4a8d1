#include "system/listing.h"

#include <gtest/gtest.h>

namespace lumaknot {
namespace {

TEST(Listing, has_the_conjunction_before_the_last_item) {
  EXPECT_EQ(listing({".obj", ".ply", ".off"}, "or"), ".obj, .ply or .off");
  EXPECT_EQ(listing({".ply", ".stl"}, "and"), ".ply and .stl");
  EXPECT_EQ(listing({".glb"}, "or"), ".glb");
  EXPECT_EQ(listing({}, "or"), "");
}

}  // namespace
}  // namespace lumaknot
