/// An OpenGL context without a window or a display.
#pragma once

#include <string>

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

/// GL 3.3 core or GLES 3.0 without a surface, current during its lifetime: on EGL's surfaceless
/// platform, or on the first of EGL's devices that is hardware. All GL objects are destroyed with
/// it.
class GlContext {
 public:
  /// Throws Unavailable.
  GlContext(Api api, bool hardware);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

/// The current context's GL_RENDERER.
std::string gl_renderer();

/// The current context's renderer and version, on one line.
std::string gl_version();

}  // namespace lumaknot::gpu
