/// How a frame's time grows with its work: triangles, pixels, samples.
#pragma once

#include <string>
#include <vector>

#include "render/render.h"
#include "scene/scene.h"
#include "study/statistics.h"

namespace lumaknot {

struct GrowthOptions {
  int threads = 0;       ///< 0: one for each core
  double seconds = 0.3;  ///< that each step draws
};

/// One amount of work.
struct GrowthStep {
  std::string name;     ///< "61440 triangles"
  double work = 0;      ///< triangles, pixels, or samples a pixel
  Spread milliseconds;  ///< of a frame
};

/// A frame with more and more of one thing, all else as the scene has it.
struct Growth {
  std::string name;  ///< "triangles"
  std::vector<GrowthStep> steps;
};

/// The slope of step i > 0 in a double logarithmic chart: 1 is linear, less is better.
double slope_of(const Growth& growth, std::size_t i);

/// Times our fast frames, trilinear. Triangles grow where `mesh` is a knot: its grid in a tenth, as
/// it is, and in ten and a hundred times as many. Pixels grow from a sixteenth to 64 times.
std::vector<Growth> measure_growth(const Scene& scene, const MeshSpec& mesh,
                                   const GrowthOptions& options, const Progress& progress);

/// Tables for a terminal.
std::string growth_text(const std::vector<Growth>& all);

/// JSON, two spaces deep, ending in a newline.
std::string growth_json(const std::vector<Growth>& all);

/// A double logarithmic chart as SVG: the time over the work, each as a multiple of the scene's own
/// least.
std::string growth_svg(const std::vector<Growth>& all);

}  // namespace lumaknot
