/// Whether pictures meet a tolerance.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "render/exact/pixels.h"
#include "render/reference.h"
#include "study/plan/neighborhood.h"

namespace lumaknot::plan {

/// How a picture compares with the truth. Errors are of the largest channel, including coverage, of
/// each pixel that the picture or the truth covers, unrounded, colours limited to [0, 1].
struct ToleranceResult {
  /// The largest: in place if that is within the tolerance, else by the first look around the pixel
  /// that shows it to be, else by a full one.
  double error = 0;
  double in_place = 0;       ///< the largest, from the truth at the same pixel
  double mean_in_place = 0;  ///< the mean of those
  long long covered = 0;     ///< pixels that the picture or the truth covers
  long long shifted = 0;     ///< those beyond the tolerance in place
  long long hidden = 0;      ///< those within it only by what less than the shift hides
  long long failing = 0;     ///< those beyond the tolerance; if stopped early, at least this many
  long long lacking = 0;     ///< pixels that would also have to be within it in place, as demanded
  bool met = false;

  long long met_in_place() const { return covered - shifted; }
  /// Those within the tolerance only by the shift; if stopped early, at most this many.
  long long met_by_shift() const { return shifted - failing; }
  /// `pixels` as a share of those covered, in [0, 1].
  double share(long long pixels) const { return double(pixels) / double(std::max(1LL, covered)); }
  /// Whether the tolerance is missed by far: by more pixels than kFar.
  bool misses_by_far() const { return std::max(failing, lacking) > kFar; }

  static constexpr long long kFar = 16;
};

/// A result pixel by pixel.
struct PixelErrors {
  ToleranceResult total;
  Grid<float> errors, in_place;
};

/// The truth of a scene, and pictures checked against it.
class ToleranceChecker {
 public:
  /// The scene on the exact surface of `knot`, in the material's own space with unit normals. A
  /// pixel is its centre if the scene has one sample per pixel, else the mean over its square.
  /// Throws Error as ExactTube does, and if no pixel is covered; all throw Interrupted.
  ToleranceChecker(Scene scene, const KnotSpec& knot, const Tolerance& tolerance,
                   const Progress& progress = {});
  ToleranceChecker(const ToleranceChecker&) = delete;
  ToleranceChecker& operator=(const ToleranceChecker&) = delete;

  /// Stops early if the tolerance is missed by far: when more pixels than ToleranceResult::kFar
  /// fail and no other can be worse, so that `error` is that of all.
  ToleranceResult check(const Image& picture) const;

  PixelErrors check_all(const Image& picture) const;

  const Tolerance& tolerance() const { return tolerance_; }
  bool area() const { return area_; }
  const Image& truth() const { return truth_; }

  /// The exact surface as seen from each pixel's centre.
  const Grid<exact::ExactFragment>& fragments() const { return fragments_; }

 private:
  /// A pixel that is beyond the tolerance as far as it was examined.
  struct Suspect {
    std::size_t pixel = 0;
    double error = 0;     ///< the largest possible
    int looks = 0;        ///< around the pixel, each closer
    bool hidden = false;  ///< within the tolerance only by what less than the shift hides
  };

  void look_at_centres();
  void take_centres();
  void take_means(const Progress& progress);
  PixelErrors examine(const Image& picture, bool all) const;
  std::vector<Suspect> suspects(const Image& picture, PixelErrors& result) const;
  void look_closer(Suspect& suspect, const exact::Sample& sample) const;

  Scene scene_;
  Tolerance tolerance_;
  bool area_;
  exact::ExactPixels pixels_;
  PixelNeighborhood neighborhood_;
  Grid<exact::ExactFragment> fragments_;
  Image truth_;
  /// Per pixel; examined when a picture needs it. Each pixel by one thread at a time.
  mutable std::vector<std::unique_ptr<NeighborhoodRange>> ranges_;
};

}  // namespace lumaknot::plan
