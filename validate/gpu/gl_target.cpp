#include "validate/gpu/gl_target.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "validate/gpu/unavailable.h"

namespace lumaknot::gpu {
namespace {

GLuint make_renderbuffer(const Job& job, GLenum format, int samples) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  if (samples == 1) {
    glRenderbufferStorage(GL_RENDERBUFFER, format, job.width, job.height);
  } else {
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, job.width, job.height);
  }
  return buffer;
}

/// Bound when it returns.
GLuint make_framebuffer(const Job& job, int samples) {
  GLuint target = 0;
  glGenFramebuffers(1, &target);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                            make_renderbuffer(job, job.bytes ? GL_RGBA8 : GL_RGBA32F, samples));
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                            make_renderbuffer(job, GL_DEPTH_COMPONENT32F, samples));
  check_gl("the image");
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Unavailable(fmt::format("the driver can't draw into four {} per pixel with {} samples",
                                  job.bytes ? "bytes" : "floats", samples));
  }
  return target;
}

int samples_here(int wanted) {
  GLint max = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &max);
  return std::clamp(wanted, 1, std::max(max, 1));
}

}  // namespace

void check_gl(std::string_view what) {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) throw Unavailable(fmt::format("{}: GL error 0x{:x}", what, error));
}

void check_side(int side, unsigned limit, std::string_view what) {
  GLint max = 0;
  glGetIntegerv(limit, &max);
  if (side <= max) return;
  throw Unavailable(fmt::format("{} has a side of {}, the driver's limit is {}", what, side, max));
}

GlTarget::GlTarget(const Job& job) : job_(job), samples_(samples_here(job.samples)) {
  check_side(std::max(job.width, job.height), GL_MAX_RENDERBUFFER_SIZE, "the image");
  resolved_ = make_framebuffer(job, 1);
  drawn_ = samples_ == 1 ? resolved_ : make_framebuffer(job, samples_);
}

void GlTarget::resolve() const {
  if (drawn_ == resolved_) return;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  glBlitFramebuffer(0, 0, job_.width, job_.height, 0, 0, job_.width, job_.height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, drawn_);
}

std::vector<float> GlTarget::pixels() const {
  std::vector<float> pixels(image_floats(job_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  if (job_.bytes) {  // the only format in which GLES reads bytes
    std::vector<unsigned char> bytes(pixels.size());
    glReadPixels(0, 0, job_.width, job_.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    std::ranges::transform(bytes, pixels.begin(), [](unsigned char b) { return float(b) / 255; });
  } else {
    glReadPixels(0, 0, job_.width, job_.height, GL_RGBA, GL_FLOAT, pixels.data());
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
  const auto row = std::ptrdiff_t(job_.width) * 4;
  for (int y = 0; y < job_.height / 2; ++y) {  // GL's first row is the bottom one
    const auto low = pixels.begin() + y * row, high = pixels.begin() + (job_.height - 1 - y) * row;
    std::swap_ranges(low, low + row, high);
  }
  return pixels;
}

}  // namespace lumaknot::gpu
