/// Other programs as points of a chart.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/spec.h"
#include "study/chart/points.h"

namespace lumaknot::chart {

/// One frame of another program, and how long such frames took.
struct OtherFrame {
  std::string name;  ///< begins with the program's
  std::string how;   ///< what its time covers
  Space space;
  int samples = 1;
  Image image;
  std::vector<double> milliseconds;
};

struct OtherResult {
  std::vector<OtherFrame> frames;
  std::vector<MissingPoint> missing;
};

/// A program that draws scenes.
class OtherProgram {
 public:
  virtual ~OtherProgram() = default;
  virtual std::string name() const = 0;

  /// Draws `scene`, whose mesh is that of `own`, in each space. Throws only Interrupted.
  virtual OtherResult measure(const Scene& scene, std::span<const Space> spaces,
                              const measure::Method& own) = 0;
};

/// llvmpipe, Cycles, POV-Ray and Eevee.
std::vector<std::unique_ptr<OtherProgram>> other_programs();

}  // namespace lumaknot::chart
