/// Whether pictures meet a tolerance.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "render/exact_pixels.h"
#include "render/render.h"
#include "study/planning/nearby.h"

namespace lumaknot {

/// How a picture stands to the truth. Errors are of the largest channel, coverage among them, of
/// every pixel that the picture or the truth covers, unrounded, colours limited to [0, 1].
struct ToleranceResult {
  /// The largest: in place where that is within the tolerance, else from what the first look about
  /// the pixel finds that shows it to be, else from what a full one does.
  double error = 0;
  double in_place = 0;       ///< the largest, from the truth at the very pixel
  double mean_in_place = 0;  ///< the mean of those
  long long covered = 0;     ///< pixels that the picture or the truth covers
  long long shifted = 0;     ///< those beyond the tolerance in place
  long long hidden = 0;      ///< those within it by what is hidden by less than the shift alone
  long long failing = 0;     ///< those beyond the tolerance; when stopped early, at least so many
  bool met = false;
};

/// A picture of which more pixels than this fail misses the tolerance by far.
inline constexpr long long kFar = 16;

/// A judgement pixel by pixel.
struct PixelErrors {
  ToleranceResult judgement;
  Grid<float> errors, in_place;
};

/// The truth of a scene, and pictures held to it.
class Judge {
 public:
  /// The scene on the exact surface of `knot`, in the material's own space with unit normals. What
  /// a pixel is: its centre where the scene has one sample a pixel, else the mean over its square.
  /// Throws Error as ExactTube, and when no pixel is covered; Interrupted, as what follows does.
  Judge(Scene scene, const KnotSpec& knot, const Tolerance& tolerance,
        const Progress& progress = {});
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;

  /// Stops early where the tolerance is missed by far: when more pixels than kFar fail and no other
  /// can be worse, so that `error` is that of all.
  ToleranceResult judge(const Image& picture) const;

  PixelErrors judge_all(const Image& picture) const;

  const Tolerance& tolerance() const { return tolerance_; }
  bool area() const { return area_; }
  const Image& truth() const { return truth_; }

  /// What each pixel's centre sees of the exact surface.
  const Grid<ExactFragment>& fragments() const { return fragments_; }

 private:
  /// A pixel that is beyond the tolerance, as far as it was looked at.
  struct Suspect {
    std::size_t pixel = 0;
    double error = 0;     ///< the most that it can be
    int looks = 0;        ///< about the pixel, each closer
    bool hidden = false;  ///< within the tolerance of what is hidden by less than the shift alone
  };

  void look_at_centres();
  void take_centres();
  void take_means(const Progress& progress);
  PixelErrors examine(const Image& picture, bool all) const;
  std::vector<Suspect> suspects(const Image& picture, PixelErrors& result) const;
  void look_closer(Suspect& suspect, const Sample& sample) const;

  Scene scene_;
  Tolerance tolerance_;
  bool area_;
  ExactPixels pixels_;
  Nearby nearby_;
  Grid<ExactFragment> fragments_;
  Image truth_;
  /// Of each pixel; looked about when a picture needs it. Each pixel by one thread at a time.
  mutable std::vector<std::unique_ptr<NearbyRange>> ranges_;
};

}  // namespace lumaknot
