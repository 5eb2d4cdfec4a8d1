/// An OpenGL context without a window or a display.
#pragma once

#include <string>

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

/// GL 3.3 core or GLES 3.0 on EGL's surfaceless platform, current while it lives. All GL objects
/// end with it.
class GlContext {
 public:
  /// Throws Unavailable.
  explicit GlContext(Api api);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

/// The current context's renderer and version, on one line.
std::string gl_version();

}  // namespace lumaknot::gpu
