/// GL's render target, and reading it back.
#pragma once

#include <vector>

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

/// Throws Unavailable naming `what` if GL reports an error.
void check_gl(std::string_view what);

/// Throws Unavailable if `side` exceeds the driver's value of `limit`, a GLenum.
void check_side(int side, unsigned limit, std::string_view what);

/// An image with float depth, of one or more samples per pixel, bound for drawing.
class GlTarget {
 public:
  /// `job` must outlive it. Throws Unavailable.
  explicit GlTarget(const Job& job);

  /// Averages the samples per pixel if there are several.
  void resolve() const;

  /// RGBA floats, the top row first.
  std::vector<float> pixels() const;

  int samples() const { return samples_; }

 private:
  const Job& job_;
  int samples_ = 1;
  unsigned drawn_ = 0, resolved_ = 0;  ///< framebuffers, the same with one sample
};

}  // namespace lumaknot::gpu
