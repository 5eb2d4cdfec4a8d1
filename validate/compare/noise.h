/// Pictures drawn with random samples, judged by statistics.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "render/filtered.h"
#include "validate/compare/images.h"

namespace lumaknot::validate {

/// Two pictures of one shot and what they should be on average.
struct NoisyPair {
  const Image &first, &second;  ///< drawn alike, with other random samples
  const FilteredImage& expected;
  int samples;  ///< per pixel of each picture
};

inline constexpr std::array<std::string_view, 4> kChannelNames{"red", "green", "blue", "coverage"};
inline constexpr std::size_t kCoverageChannel = 3;

/// A channel of kChannelNames.
double channel_of(const RgbaPixel& pixel, std::size_t channel);

/// A block of pixels in one channel, and how far both pictures are from their expectation.
struct NoiseFinding {
  PixelPlace place;         ///< of its top left pixel
  std::size_t channel = 0;  ///< of kChannelNames
  double bias = 0;          ///< the mean of both pictures less ours
  double distance = 0;      ///< of the nearer picture from ours; 0 if they are on two sides
  double admitted = 0;      ///< what that may be
  double deviation = 0;     ///< the standard deviation of one picture there

  bool exceeds() const { return distance > admitted; }
  double share() const { return admitted > 0 ? distance / admitted : 0; }
};

/// The blocks of one size.
struct NoiseScale {
  int block = 1;                    ///< side in pixels; the last one's holds the whole picture
  long long tests = 0;              ///< blocks times channels
  long long exceeded = 0;           ///< of those, in a colour
  long long coverage_exceeded = 0;  ///< in coverage
  NoiseFinding worst;               ///< with the largest share of what is admitted
  /// Of the colour that has most: the deviation of one picture, root mean square over the blocks
  /// with any, and the bias that is noticed in half of these blocks with a chance of 95 %.
  double noise = 0, seen = 0;
};

/// Whether two noisy pictures agree with their expectation, at every scale.
struct NoiseTest {
  double family_error = 0;  ///< the chance that pictures without any bias are found to differ
  std::vector<NoiseScale> scales;
  Grid<PixelMark> marks;  ///< blocks smaller than the picture that exceed what is admitted

  /// How many tests exceed what is admitted, at all scales, in coverage or in a colour.
  long long exceeded(bool in_coverage) const;
};

/// Tests each channel at blocks of 1, 4, 16, ... pixels and as a whole. A block differs if both
/// pictures are on the same side of the expectation, each farther than is admitted.
///
/// The family error is shared equally by the scales, then by their tests (Bonferroni). A single
/// pixel is admitted what Bernstein's inequality says of independent samples, which are never
/// better than a renderer's stratified ones. The variance of blocks is the sum of their pixels',
/// each of which is that of the pictures' difference (one degree of freedom), pooled over 512
/// pixels whose samples spread alike. What the blocks' own differences say beyond that counts:
/// their variance, and their kurtosis as degrees of freedom of Student's t. Distances are reduced
/// by what rounding and our own sampling may cause.
NoiseTest test_noise(const NoisyPair& pair, double family_error);

}  // namespace lumaknot::validate
