/// Frames per second of the classical model and of the paper's, ours next to other programs':
/// Table 2 of Kotsarenko and Ramos, "Alternative Diffuse Lighting and Specular Reflection Approach
/// Using YIQ Color Space".
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/reference.h"
#include "scene/shot.h"
#include "scene/spec.h"
#include "study/measure/statistics.h"

namespace lumaknot::bench {

/// What is drawn: eq. 3; eq. 6-8 collapsed; Table 1's listing as it is written.
inline constexpr std::array<std::string_view, 3> kRateShots{"classical", "yiq", "table1"};

/// The shots that are timed, Phong's model with the scene's numbers.
std::vector<Shot> rate_shots(const Scene& scene);

struct RateOptions {
  std::vector<int> samples{1, 8};  ///< a row for each
  int threads = 0;                 ///< a row for one and a row for this many; 0: one per core
  int rounds = 5;                  ///< each draws every row
  double seconds = 0.5;            ///< of drawing, per row and round
  bool peers = true;               ///< other programs' rows too
};

/// Milliseconds per frame: [shot of kRateShots][frame], equally many of each.
using FrameTimes = std::array<std::vector<double>, kRateShots.size()>;

/// One renderer with one number of threads and samples.
struct RateRow {
  std::string renderer;  ///< as it names itself
  int threads = 0;       ///< 0: a GPU's driver has its own
  int samples = 1;       ///< per pixel, as drawn
  std::string how;       ///< what is particular to its frames
  std::array<measure::Spread, kRateShots.size()> milliseconds{};
  std::array<double, kRateShots.size()> costs{};  ///< share of the classical rate that is lost
  /// Of the costs: the median's 95 % interval over all pairs of frames, and each round's median.
  std::array<Interval<double>, kRateShots.size()> cost_intervals{};
  double ratio = 1;  ///< its time over ours with equal threads and samples, or the next more
                     ///< samples; paired by round
};

/// A renderer that has no rows.
struct MissingRates {
  std::string renderer, why;  ///< the reason and the remedy
};

struct RateTable {
  int width = 0, height = 0;
  std::vector<RateRow> rows;
  std::vector<MissingRates> missing;
};

/// The summary of all rounds of a row, except for its ratio.
void summarise(std::span<const FrameTimes> rounds, RateRow& row);

/// Draws `scene` in rounds with our fast renderer and, if available, with llvmpipe, a GPU and
/// Embree. Throws Error for unsupported sample counts, and Interrupted.
RateTable measure_rates(const Scene& scene, const RateOptions& options,
                        const Progress& progress = {});

}  // namespace lumaknot::bench
