/// The report's pictures: ours, and what makes each renderer's of it.
#pragma once

#include <string>

#include "validate/compare/difference_code.h"
#include "validate/compare/images.h"

namespace lumaknot::validate {

/// Our picture of a shot, as PNG files.
struct OwnPicture {
  std::string display;     ///< 8 bits, limited to [0, 1]
  CodedDifference excess;  ///< what limiting took away; without a PNG if nothing
};

/// A renderer's picture of a shot, as PNG files from which a page makes it: ours + difference.
struct Pictures {
  CodedDifference difference;  ///< theirs - ours, limited to [0, 1] first if they are so compared
  std::string marks;           ///< grey, a PixelMark per pixel
  std::string flip;            ///< grey, FLIP's [0, 1] as [0, 255]; empty below kFlipFrom
  double mean_flip = 0;        ///< if `flip` is not empty
  /// Ours of the shot drawn instead of the one requested. Its display holds what to add to the
  /// requested one's bytes, modulo 256.
  OwnPicture instead;
  std::string display;  ///< theirs as a whole, for those who asked for it; see display_png()
};

/// Where no channel differs by that much, FLIP is below 0.04 everywhere, and not computed.
inline constexpr double kFlipFrom = 1.0 / 512;

/// Pages show images of at most so many pixels; larger ones have their blocks' means.
inline constexpr long long kMaxPagePixels = 1LL << 20;

/// The side of the blocks of pixels that a page shows as one.
int page_block(int width, int height);

/// The bytes that each renderer's picture of a shot may take, of `count` such pictures; one that
/// differs everywhere may take more.
std::size_t picture_budget(std::size_t count);

OwnPicture own_picture(const Image& image, std::size_t budget);

/// A grey PNG file of what `reference` covers: 0 nothing, 1 surface, 2 surface at a silhouette.
std::string cover_png(const Reference& reference);

/// What a renderer's picture is compared with.
struct Compared {
  const Image& ours;
  const Image& theirs;
  bool limited;  ///< compared after limiting both to [0, 1]
};

/// All but `instead` and `display`.
Pictures pictures_of(const Compared& pair, const Grid<PixelMark>& marks, std::size_t budget);

/// The picture drawn instead of `requested`, for Pictures::instead.
OwnPicture instead_picture(const Image& requested, const Image& instead, std::size_t budget);

}  // namespace lumaknot::validate
