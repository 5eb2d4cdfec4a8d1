/// Frames by primary rays, shaded with the shaders' own formulas.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bench/embree/job.h"
#include "bench/embree/tracer.h"
#include "scene/image.h"

namespace lumaknot::embree {

/// Pixels of 8 bits per channel, red in the lowest byte, coverage in the highest.
using Frame = Grid<std::uint32_t>;

/// A job's mesh, laid out for shading, and its texture.
class Surface {
 public:
  /// `job` must outlive it.
  explicit Surface(const Job& job);

  const std::int32_t* attributes() const { return attributes_.data(); }
  const PackedTexture* texture() const { return texture_; }

 private:
  // kStride floats per triangle, as their bits: xsimd 8.1 gathers only integers by one instruction.
  std::vector<std::int32_t> attributes_;
  const PackedTexture* texture_;
};

/// Draws `draw` with `samples` rays per pixel into `frame`, which has its size. On all of TBB's
/// threads.
void draw_frame(const Tracer& tracer, const Surface& surface, const Draw& draw, int samples,
                Frame& frame);

/// "16 lanes a packet"
std::string shading_width();

}  // namespace lumaknot::embree
