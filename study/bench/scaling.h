/// How a frame's time scales with its work: triangles, pixels, samples.
#pragma once

#include <string>
#include <vector>

#include "render/reference.h"
#include "scene/spec.h"
#include "study/measure/statistics.h"

namespace lumaknot::bench {

struct ScalingOptions {
  int threads = 0;       ///< 0: one per core
  double seconds = 0.3;  ///< of drawing, per step
};

/// One amount of work.
struct ScalingStep {
  std::string name;              ///< "61440 triangles"
  double work = 0;               ///< triangles, pixels, or samples per pixel
  measure::Spread milliseconds;  ///< of a frame
};

/// A frame with more and more of one thing, all else as in the scene.
struct Scaling {
  std::string name;  ///< "triangles"
  std::vector<ScalingStep> steps;
};

/// The slope of step i > 0 in a double logarithmic chart: 1 is linear, lower is better.
double slope_of(const Scaling& scaling, std::size_t i);

/// Times our fast frames, trilinear. Triangles grow where `mesh` is a knot: a tenth of its
/// grid, the grid itself, and ten and a hundred times as many. Pixels grow from a sixteenth to 64
/// times.
std::vector<Scaling> measure_scaling(const Scene& scene, const MeshSpec& mesh,
                                     const ScalingOptions& options, const Progress& progress);

/// Tables for a terminal.
std::string scaling_text(const std::vector<Scaling>& all);

/// JSON, two spaces deep, ending in a newline.
std::string scaling_json(const std::vector<Scaling>& all);

/// A double logarithmic chart as SVG: the time over the work, each as a multiple of the
/// smallest.
std::string scaling_svg(const std::vector<Scaling>& all);

}  // namespace lumaknot::bench
