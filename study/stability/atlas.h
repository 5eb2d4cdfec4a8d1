/// The atlas: every region swept, its boundary found and drawn.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/stability/region.h"

namespace lumaknot::stability {

/// A region's picture at one value.
struct Picture {
  std::string caption;  ///< empty for the chart, which needs none
  std::string file;     ///< its name in the region's folder
  std::string png;
};

/// Another quantity: where the method is shown holding, on both sides of the boundary, and where it
/// is shown failing.
struct AlsoMeasured {
  std::string name;
  double holds = 0, last_holding = 0, first_failing = 0, fails = 0;
};

/// A region examined.
struct Entry {
  std::string name, group, method, reason, remedy, parameter, measured;
  double limit = 0;
  Boundary boundary;
  double guarded_worst = 0;  ///< of the remedy over the whole sweep; not a number if there is none
  std::vector<Measured> sweep, guarded;  ///< the chart's points
  std::vector<AlsoMeasured> also;
  std::vector<Picture> pictures;  ///< the chart; holding, failing, the remedy and the difference
};

struct AtlasOptions {
  bool pictures = true;  ///< charts and sketches; they need gnuplot
  int steps = 40;        ///< of a sweep
  int side = 200;        ///< of a sketch, pixels
};

/// The intervals of swept values beyond the boundary that hold again.
std::vector<SweepInterval> holding_again(const Entry& entry);

/// Sweeps the region, finds its boundary and draws it. `tick` is called at each value with the
/// finished share in [0, 1]; its exceptions end the work.
Entry examine(const Region& region, const AtlasOptions& options,
              const std::function<void(double)>& tick);

/// The chart of a region's sweep as SVG: error against parameter, the limit, and a shade on the
/// intervals that were measured to fail, the first of them from the boundary on.
std::string sweep_chart(const Region& region, const Entry& entry);

}  // namespace lumaknot::stability
