/// A job's pictures drawn by GL or GLES.
#pragma once

#include <vector>

#include "validate/gpu/gl_context.h"

namespace lumaknot::gpu {

/// A context that holds the job's mesh, textures and target.
class GlRun {
 public:
  /// `job` must outlive it. Throws Unavailable.
  explicit GlRun(const Job& job);

  /// The picture as RGBA floats, top row first. Throws Unavailable, or Error for a wrong uniform.
  std::vector<float> draw(const Draw& draw) const;

 private:
  GlContext context_;
  const Job& job_;
};

}  // namespace lumaknot::gpu
