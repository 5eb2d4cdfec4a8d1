#include "validate/gpu/gl_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "system/error.h"
#include "validate/gpu/unavailable.h"

namespace lumaknot::gpu {
namespace {

/// The log, then a line that names the file it is about.
[[noreturn]] void fail(std::string log, const std::string& where, std::string_view what) {
  if (!log.empty() && log.back() != '\n') log += '\n';
  throw Unavailable(
      fmt::format("{}{} does not {}: {}", log, where, what, log.substr(0, log.find('\n'))));
}

/// A shader's or program's log, by the functions that return its length and text.
template <class Get, class Text>
std::string log_of(GLuint object, Get get, Text text) {
  GLint length = 0;
  get(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(std::max(length, 0)), '\0');
  if (length > 0) text(object, length, &length, log.data());
  log.resize(std::size_t(std::max(length, 0)));
  return log;
}

GLuint compile(const Shader& shader, GLenum stage) {
  const GLuint object = glCreateShader(stage);
  const char* code = shader.code.data();
  const GLint length = GLint(shader.code.size());
  glShaderSource(object, 1, &code, &length);
  glCompileShader(object);
  GLint good = 0;
  glGetShaderiv(object, GL_COMPILE_STATUS, &good);
  if (!good) {
    fail(log_of(object, glGetShaderiv, glGetShaderInfoLog), shader.where, "compile");
  }
  return object;
}

/// The GLSL type of a number of values.
std::string_view type_of(std::size_t values) {
  switch (values) {
    case 1:
      return "float";
    case 2:
      return "vec2";
    case 3:
      return "vec3";
    case 4:
      return "vec4";
    case 9:
      return "mat3";
    default:
      return "mat4";
  }
}

void set_values(GLint location, const std::vector<float>& values) {
  const float* v = values.data();
  switch (values.size()) {
    case 1:
      return glUniform1fv(location, 1, v);
    case 2:
      return glUniform2fv(location, 1, v);
    case 3:
      return glUniform3fv(location, 1, v);
    case 4:
      return glUniform4fv(location, 1, v);
    case 9:
      return glUniformMatrix3fv(location, 1, GL_FALSE, v);
    default:
      return glUniformMatrix4fv(location, 1, GL_FALSE, v);
  }
}

/// An active uniform or attribute.
struct Active {
  std::string name;
  GLint size = 0;  ///< number of array elements, else 1
  GLenum type = 0;
};

/// All of them except GLSL's built-ins, by the functions that return their number and one of them.
template <class Get>
std::vector<Active> actives(GLuint program, GLenum how_many, Get get) {
  GLint count = 0;
  glGetProgramiv(program, how_many, &count);
  std::vector<Active> all;
  for (GLuint i = 0; i < GLuint(count); ++i) {
    std::array<char, 1024> name{};
    Active active;
    get(program, i, GLsizei(name.size()), nullptr, &active.size, &active.type, name.data());
    active.name = name.data();
    if (!active.name.starts_with("gl_")) all.push_back(active);
  }
  return all;
}

bool gives(const Draw& draw, const std::string& name) {
  return std::ranges::find(draw.uniforms, name, &Uniform::name) != draw.uniforms.end();
}

/// Whether the draw sets the whole uniform; an array, reported as "name[0]", element by element.
bool sets(const Draw& draw, const Active& uniform) {
  const std::string base = uniform.name.substr(0, uniform.name.rfind('['));
  if (uniform.size == 1) return gives(draw, uniform.name) || gives(draw, base);
  for (GLint i = 0; i < uniform.size; ++i) {
    if (!gives(draw, fmt::format("{}[{}]", base, i))) return false;
  }
  return true;
}

/// An unset uniform would be zero, and the picture wrong.
void check_uniforms(GLuint program, const Draw& draw, const std::vector<Texture>& textures) {
  for (const Active& uniform : actives(program, GL_ACTIVE_UNIFORMS, glGetActiveUniform)) {
    const bool texture =
        uniform.type == GL_SAMPLER_2D &&
        std::ranges::find(textures, uniform.name, &Texture::name) != textures.end();
    if (texture || sets(draw, uniform)) continue;
    throw Error(fmt::format("{}: the shaders read uniform {}, which the job does not set",
                            draw.where, uniform.name));
  }
}

void check_attributes(GLuint program, const Draw& draw, bool with_mesh) {
  for (const Active& attribute : actives(program, GL_ACTIVE_ATTRIBUTES, glGetActiveAttrib)) {
    const GLint location = glGetAttribLocation(program, attribute.name.c_str());
    if (with_mesh && location <= 2) continue;
    throw Error(fmt::format("{} reads {} at location {}, which {}", draw.vertex.where,
                            attribute.name, location,
                            with_mesh ? "the mesh lacks" : "needs a mesh"));
  }
}

void set_all(GLuint program, const Draw& draw, const std::vector<Texture>& textures) {
  for (const Uniform& uniform : draw.uniforms) {
    const GLint location = glGetUniformLocation(program, uniform.name.c_str());
    if (location < 0) continue;
    set_values(location, uniform.values);
    if (glGetError() == GL_NO_ERROR) continue;
    throw Error(fmt::format("{}: uniform {} is set as {}, but has another type in the shader",
                            draw.where, uniform.name, type_of(uniform.values.size())));
  }
  for (std::size_t i = 0; i < textures.size(); ++i) {
    const GLint location = glGetUniformLocation(program, textures[i].name.c_str());
    if (location >= 0) glUniform1i(location, GLint(i));
  }
}

}  // namespace

GLuint make_program(const Draw& draw) {
  const GLuint program = glCreateProgram();
  glAttachShader(program, compile(draw.vertex, GL_VERTEX_SHADER));
  glAttachShader(program, compile(draw.fragment, GL_FRAGMENT_SHADER));
  glLinkProgram(program);
  GLint good = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  const std::string log = log_of(program, glGetProgramiv, glGetProgramInfoLog);
  // Mesa only warns about a varying that is never written, and draws something.
  if (!good || !log.empty()) fail(log, draw.where, "link");
  return program;
}

void use_program(GLuint program, const Job& job, const Draw& draw) {
  check_uniforms(program, draw, job.textures);
  check_attributes(program, draw, job.mesh.has_value());
  glUseProgram(program);
  set_all(program, draw, job.textures);
}

}  // namespace lumaknot::gpu
