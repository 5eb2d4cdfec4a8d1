#include "validate/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/validate/small_scene.h"

namespace lumaknot::validate {
namespace {

Image plain(int width, int height, const Rgb& color) {
  Image image(width, height);
  for (RgbaPixel& p : image.pixels) p = {color, 1};
  return image;
}

TEST(PageBlock, keeps_pictures_that_are_small_enough_and_shrinks_others_to_fit) {
  EXPECT_EQ(page_block(720, 720), 1);
  EXPECT_EQ(page_block(1024, 1024), 1);
  EXPECT_EQ(page_block(1025, 1024), 2);
  EXPECT_EQ(page_block(4096, 4096), 4);
}

TEST(PictureBudget, is_shared_by_all_and_never_nothing) {
  EXPECT_GT(picture_budget(1), 20 * picture_budget(30));
  EXPECT_EQ(picture_budget(1000), picture_budget(100000));
}

TEST(OwnPicture, has_an_excess_only_where_a_display_cannot_show_it) {
  EXPECT_TRUE(own_picture(plain(8, 8, {0, 0.5f, 1}), 1 << 20).excess.png.empty());
  const OwnPicture bright = own_picture(plain(8, 8, {0, 0.5f, 1.5f}), 1 << 20);
  EXPECT_FALSE(bright.excess.png.empty());
  EXPECT_GT(bright.excess.step, 0);
}

/// The pictures of two plain images.
Pictures between(const Rgb& ours, const Rgb& theirs) {
  return pictures_of({plain(40, 30, ours), plain(40, 30, theirs), false}, {40, 30}, 1 << 20);
}

TEST(Pictures, have_a_flip_map_only_where_a_channel_differs_enough) {
  EXPECT_TRUE(between({0, 0.5f, 1}, {0, 0.501f, 1}).flip.empty());
  const Pictures differ = between({0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(differ.flip.empty());
  EXPECT_GT(differ.mean_flip, 0.9);
}

TEST(Pictures, what_has_no_flip_map_has_no_flip_that_a_map_would_show) {
  for (const float grey : {0.0f, 0.02f, 0.1f, 0.5f, 1 - float(kFlipFrom)}) {
    const float other = grey + float(kFlipFrom);
    EXPECT_LT(between({grey, grey, grey}, {other, other, other}).mean_flip, 0.04) << grey;
    EXPECT_LT(between({grey, grey, grey}, {other, grey, other}).mean_flip, 0.04) << grey;
    EXPECT_LT(between({grey, grey, grey}, {grey, other, grey}).mean_flip, 0.04) << grey;
  }
}

TEST(Pictures, of_a_shot_drawn_instead_hold_nothing_where_it_is_the_same) {
  const Image same = plain(720, 720, {0.3f, 0.4f, 0.5f});
  const OwnPicture instead = instead_picture(same, same, 1 << 20);
  EXPECT_LT(instead.display.size(), 3000u);
  EXPECT_TRUE(instead.excess.png.empty());
}

}  // namespace
}  // namespace lumaknot::validate
