/// A job's pictures drawn by GL or GLES.
#pragma once

#include <vector>

#include "validate/gpu/gl_context.h"
#include "validate/gpu/gl_target.h"

namespace lumaknot::gpu {

/// A context that holds the job's mesh, textures and target.
class GlRun {
 public:
  /// `job` must outlive it. Throws Unavailable.
  explicit GlRun(const Job& job);

  /// The draw's shaders, ready to be drawn with. Throws Unavailable, or Error for a wrong uniform.
  unsigned prepare(const Draw& draw) const;

  /// Draws with what prepare() returned and waits until the driver has finished.
  void draw_frame(unsigned program) const;

  /// Writes the last picture drawn to the draw's output.
  void write_image(const Draw& draw) const;

  int samples() const { return target_.samples(); }

 private:
  GlContext context_;
  const Job& job_;
  GlTarget target_;
};

}  // namespace lumaknot::gpu
