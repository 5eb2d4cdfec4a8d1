/// What GL draws into, and how it gets out.
#pragma once

#include <vector>

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

/// Throws Unavailable naming `what` where GL has an error to tell.
void check_gl(std::string_view what);

/// Throws Unavailable where `side` is beyond what the driver tells of `limit`, a GLenum.
void check_side(int side, unsigned limit, std::string_view what);

/// An image with a float depth, of one or more samples a pixel, bound to be drawn into.
class GlTarget {
 public:
  /// `job` must outlive it. Throws Unavailable.
  explicit GlTarget(const Job& job);

  /// Averages the samples of a pixel, where it has several.
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
