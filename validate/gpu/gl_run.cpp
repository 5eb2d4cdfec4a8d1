#include "validate/gpu/gl_run.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "system/atomic_file.h"
#include "validate/gpu/gl_program.h"
#include "validate/gpu/unavailable.h"

namespace lumaknot::gpu {
namespace {

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

/// Table 1's state: depth test "less or equal", depth written, no blending; culling only on
/// request.
void set_state(const Job& job) {
  glViewport(0, 0, job.width, job.height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_DITHER);
  glDisable(GL_BLEND);
  if (job.cull_back_faces) {
    glEnable(GL_CULL_FACE);
  } else {
    glDisable(GL_CULL_FACE);
  }
  glClearColor(0, 0, 0, 0);
}

GLint min_filter(Filter filter) {
  if (filter == Filter::kTrilinear) return GL_LINEAR_MIPMAP_LINEAR;
  return filter == Filter::kLinear ? GL_LINEAR : GL_NEAREST;
}

std::vector<unsigned char> texel_bytes(const Texture& texture) {
  std::vector<unsigned char> bytes(texture.texels.size());
  std::ranges::transform(texture.texels, bytes.begin(), [](float v) {
    return static_cast<unsigned char>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255));
  });
  return bytes;
}

void upload_texture(const Texture& texture, std::size_t unit, bool bytes) {
  check_side(std::max(texture.width, texture.height), GL_MAX_TEXTURE_SIZE,
             fmt::format("textures[{}]", unit));
  GLuint object = 0;
  glGenTextures(1, &object);
  glActiveTexture(GL_TEXTURE0 + GLenum(unit));
  glBindTexture(GL_TEXTURE_2D, object);
  if (bytes) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture.width, texture.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texel_bytes(texture).data());
  } else {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, texture.width, texture.height, 0, GL_RGBA, GL_FLOAT,
                 texture.texels.data());
  }
  const bool nearest = texture.filter == Filter::kNearest;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min_filter(texture.filter));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  if (texture.filter == Filter::kTrilinear) {
    glGenerateMipmap(GL_TEXTURE_2D);
  } else {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  }
}

}  // namespace

GlRun::GlRun(const Job& job) : context_(job.api, job.hardware), job_(job), target_(job) {
  upload_mesh(job);
  for (std::size_t i = 0; i < job.textures.size(); ++i) {
    upload_texture(job.textures[i], i, job.bytes);
  }
  set_state(job);
  check_gl("mesh and textures");
}

unsigned GlRun::prepare(const Draw& draw) const {
  const GLuint program = make_program(draw);
  use_program(program, job_, draw);
  return program;
}

void GlRun::draw_frame(unsigned program) const {
  glUseProgram(program);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (job_.mesh) {
    glDrawElements(GL_TRIANGLES, GLsizei(job_.mesh->indices.size()), GL_UNSIGNED_INT, nullptr);
  } else {
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  target_.resolve();
  glFinish();
}

void GlRun::write_image(const Draw& draw) const {
  const std::vector<float> pixels = target_.pixels();
  check_gl(draw.where);
  write_file(draw.output,
             {reinterpret_cast<const char*>(pixels.data()), pixels.size() * sizeof(float)},
             draw.where + ".output");
}

}  // namespace lumaknot::gpu
