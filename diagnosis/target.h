/// The picture whose difference is to be named, and what its file alone says about it.
#pragma once

#include <vector>

#include "diagnosis/drawing.h"

namespace lumaknot::diagnosis {

/// How finely a picture's values are stored.
enum class Depth { kFloat, kHalf, kSixteenBits, kEightBits };

/// Facts, applied to our picture before it is compared and never called a fault.
struct Facts {
  Depth depth = Depth::kFloat;
  bool limited = false;     ///< its values can't leave [0, 1]
  bool has_alpha = true;    ///< some pixels are covered and some are not
  double alpha = 1;         ///< of every pixel where it has none
  bool soft_edges = false;  ///< some pixels are covered in part
  Vec3d background;         ///< where nothing is drawn
  double noise = 0;         ///< an error that says nothing: four times as much is noticed
};

/// `limited`: the renderer can't keep colours outside [0, 1].
Facts facts_of(const Image& picture, bool limited);

/// The picture on the pixels of a grid.
struct Target {
  PixelGrid grid;
  Facts facts;
  std::vector<Vec3d> colors;     ///< over the background
  std::vector<double> coverage;  ///< 0 or 1 of pixels that differ from the background without alpha
};

/// At most `max_pixels` of the picture's pixels.
Target target_of(const Image& picture, bool limited, long long max_pixels);

/// `ours` over the target's background, with its limits.
void show_like(const Target& target, Drawn& ours);

}  // namespace lumaknot::diagnosis
