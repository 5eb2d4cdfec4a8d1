#include "validate/compare/allowances.h"

#include <gtest/gtest.h>

namespace lumaknot::validate {
namespace {

constexpr auto kTurned = std::size_t(PixelClass::kTurnedNormal);
constexpr auto kSilhouette = std::size_t(PixelClass::kSilhouette);

TEST(Allowances, name_the_classes_in_their_order) {
  for (std::size_t i = 0; i < std::size_t(PixelClass::kUnexplained); ++i) {
    std::string title(allowance_title(i));
    std::ranges::replace(title, ' ', '-');
    EXPECT_EQ(title, kAllowanceNames[i]);
  }
}

TEST(CountWithin, is_the_share_and_what_chance_adds_to_it) {
  EXPECT_EQ(count_within(0, 1'000'000), 0);
  EXPECT_EQ(count_within(0.5, 0), 0);
  EXPECT_EQ(count_within(0.01, 10'000), 130) << "100 expected, 10 the standard deviation";
  EXPECT_EQ(count_within(0.01, 100), 4);
  EXPECT_NEAR(double(count_within(0.01, 100'000'000)) / 1e6, 1, 0.01);
}

TEST(ClassShare, is_of_the_silhouette_for_what_lies_there) {
  EXPECT_EQ(class_share(kTurned, 5, 1000, 100, {}).of, 1000);
  EXPECT_EQ(class_share(kSilhouette, 5, 1000, 100, {}).of, 100);
  EXPECT_EQ(class_share(kCoverageAllowance, 5, 1000, 100, {}).of, 100);
}

TEST(ClassShare, grows_with_the_picture_and_not_by_a_count) {
  for (const long long scale : {1, 10, 100, 1000}) {
    EXPECT_FALSE(class_share(kTurned, 5 * scale, 1000 * scale, 0, {}).exceeded);
    EXPECT_TRUE(class_share(kTurned, 30 * scale, 1000 * scale, 0, {}).exceeded);
  }
}

TEST(ClassShare, obeys_the_users_share_to_the_pixel) {
  Allowances allowances;
  allowances.stated[kTurned] = 0.2;
  EXPECT_FALSE(class_share(kTurned, 200, 1000, 0, allowances).exceeded);
  EXPECT_TRUE(class_share(kTurned, 201, 1000, 0, allowances).exceeded);
  allowances.stated[kTurned] = 0;
  EXPECT_TRUE(class_share(kTurned, 1, 1000, 0, allowances).exceeded);
}

}  // namespace
}  // namespace lumaknot::validate
