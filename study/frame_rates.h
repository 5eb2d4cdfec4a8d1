/// Frames a second of the classical model and of the paper's, ours beside those of other programs:
/// Table 2 of Kotsarenko and Ramos, "Alternative Diffuse Lighting and Specular Reflection Approach
/// Using YIQ Color Space".
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/render.h"
#include "scene/scene.h"
#include "scene/shot.h"
#include "study/statistics.h"

namespace lumaknot {

/// What is drawn: eq. 3; eq. 6-8 collapsed; Table 1's listing as it is written.
inline constexpr std::array<std::string_view, 3> kRateShots{"classical", "yiq", "table1"};

/// The shots that are timed, Phong's model with the scene's numbers.
std::vector<Shot> rate_shots(const Scene& scene);

struct RateOptions {
  std::vector<int> samples{1, 8};  ///< a row for each
  int threads = 0;                 ///< a row for one and a row for so many; 0: one for each core
  int rounds = 5;                  ///< each draws every row
  double seconds = 0.5;            ///< that a row draws in a round
  bool peers = true;               ///< other programs' rows too
};

/// Milliseconds a frame, shot by shot of kRateShots: [shot][frame], as many of each.
using FrameTimes = std::array<std::vector<double>, kRateShots.size()>;

/// One renderer with one number of threads and samples.
struct RateRow {
  std::string renderer;  ///< as it names itself
  int threads = 0;       ///< 0: a GPU's driver has its own
  int samples = 1;       ///< a pixel, as drawn
  std::string how;       ///< what is particular to its frames
  std::array<Spread, kRateShots.size()> milliseconds{};
  std::array<double, kRateShots.size()> costs{};  ///< share of the classical rate that is lost
  /// Where costs lie: the median's 95 % interval over all pairs of frames, and each round's median.
  std::array<Interval, kRateShots.size()> cost_intervals{};
  double ratio = 1;  ///< its time over ours on as many threads with as many samples, or the next
                     ///< more; paired by round
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

/// What all rounds of a row tell but for its ratio.
void summarise(std::span<const FrameTimes> rounds, RateRow& row);

/// Draws `scene` with our fast renderer and, where they are, with llvmpipe, a GPU and Embree, in
/// rounds. Throws Error for samples that there are not, and Interrupted.
RateTable measure_rates(const Scene& scene, const RateOptions& options,
                        const Progress& progress = {});

}  // namespace lumaknot
