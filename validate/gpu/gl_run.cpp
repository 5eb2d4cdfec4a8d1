#include "validate/gpu/gl_run.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "validate/gpu/gl_program.h"
#include "validate/gpu/unavailable.h"

namespace lumaknot::gpu {
namespace {

void check_error(std::string_view what) {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) throw Unavailable(fmt::format("{}: GL error 0x{:x}", what, error));
}

/// Sides beyond what the driver can do.
void check_side(int side, GLenum limit, std::string_view what) {
  GLint most = 0;
  glGetIntegerv(limit, &most);
  if (side <= most) return;
  throw Unavailable(fmt::format("{} has a side of {}, the driver's limit is {}", what, side, most));
}

GLuint make_renderbuffer(const Job& job, GLenum format) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorage(GL_RENDERBUFFER, format, job.width, job.height);
  return buffer;
}

/// Four floats a pixel and a float depth.
void make_target(const Job& job) {
  check_side(std::max(job.width, job.height), GL_MAX_RENDERBUFFER_SIZE, "the image");
  GLuint target = 0;
  glGenFramebuffers(1, &target);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                            make_renderbuffer(job, GL_RGBA32F));
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                            make_renderbuffer(job, GL_DEPTH_COMPONENT32F));
  check_error("the float target");
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Unavailable("the driver can't draw into four floats a pixel");
  }
}

template <class T>
void upload(GLenum target, const std::vector<T>& values) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, GLsizeiptr(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

/// Positions are attribute 0, normals 1, texture coordinates 2.
void upload_mesh(const Job& job) {
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  if (!job.mesh) return;
  upload(GL_ARRAY_BUFFER, job.mesh->vertices);
  upload(GL_ELEMENT_ARRAY_BUFFER, job.mesh->indices);
  const auto attribute = [](GLuint location, GLint size, std::size_t first) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, kFloatsPerVertex * sizeof(float),
                          reinterpret_cast<const void*>(first * sizeof(float)));
  };
  attribute(0, 3, 0);
  attribute(1, 3, 3);
  attribute(2, 2, 6);
}

void upload_texture(const Texture& texture, std::size_t unit) {
  check_side(std::max(texture.width, texture.height), GL_MAX_TEXTURE_SIZE,
             fmt::format("textures[{}]", unit));
  GLuint object = 0;
  glGenTextures(1, &object);
  glActiveTexture(GL_TEXTURE0 + GLenum(unit));
  glBindTexture(GL_TEXTURE_2D, object);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, texture.width, texture.height, 0, GL_RGBA, GL_FLOAT,
               texture.texels.data());
  const GLint filter = texture.linear ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

/// Table 1's state: depth test "less or equal", depth written, no blending, no culling.
void set_state(const Job& job) {
  glViewport(0, 0, job.width, job.height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_DITHER);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glClearColor(0, 0, 0, 0);
}

/// The target's pixels, the top row first. GL's first row is the bottom one.
std::vector<float> read_pixels(const Job& job) {
  std::vector<float> pixels(image_floats(job));
  glReadPixels(0, 0, job.width, job.height, GL_RGBA, GL_FLOAT, pixels.data());
  const auto row = std::ptrdiff_t(job.width) * 4;
  for (int y = 0; y < job.height / 2; ++y) {
    const auto low = pixels.begin() + y * row, high = pixels.begin() + (job.height - 1 - y) * row;
    std::swap_ranges(low, low + row, high);
  }
  return pixels;
}

}  // namespace

GlRun::GlRun(const Job& job) : context_(job.api), job_(job) {
  make_target(job);
  upload_mesh(job);
  for (std::size_t i = 0; i < job.textures.size(); ++i) upload_texture(job.textures[i], i);
  set_state(job);
  check_error("mesh and textures");
}

std::vector<float> GlRun::draw(const Draw& draw) const {
  use_program(make_program(draw), job_, draw);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (job_.mesh) {
    glDrawElements(GL_TRIANGLES, GLsizei(job_.mesh->indices.size()), GL_UNSIGNED_INT, nullptr);
  } else {
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  std::vector<float> pixels = read_pixels(job_);
  check_error(draw.where);
  return pixels;
}

}  // namespace lumaknot::gpu
