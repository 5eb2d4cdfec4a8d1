#include "validate/gpu/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "system/atomic_file.h"
#include "validate/gpu/fields.h"
#include "validate/gpu/files.h"

namespace lumaknot::gpu {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSide = 65'536;  // pixels or texels, as in scene.json
constexpr int kMaxSamples = 16, kMaxFrames = 1'000'000;
constexpr int kMaxBinding = 31;           // descriptor set 0 stays small
constexpr std::size_t kMaxTextures = 16;  // units that every GL 3.3 and ES 3.0 driver has
constexpr std::uint64_t kMaxShaderBytes = 1 << 24;
constexpr std::uint64_t kMaxBlockBytes = 16'384;  // maxUniformBufferRange of any Vulkan driver

struct ApiName {
  const char* name;
  Api api;
};
constexpr std::array<ApiName, 3> kApis{
    {{"gl", Api::kGl}, {"gles", Api::kGles}, {"vulkan", Api::kVulkan}}};

/// The context in which the parts of a job are read.
struct Context {
  Api api;
  fs::path folder;
  bool vulkan() const { return api == Api::kVulkan; }
};

Filter read_filter(Fields& fields, const Context& context) {
  const std::string name = fields.text("filter");
  if (name == "linear") return Filter::kLinear;
  if (name == "nearest") return Filter::kNearest;
  if (name == "trilinear" && !context.vulkan()) return Filter::kTrilinear;
  fields.fail("filter", context.vulkan() ? "linear or nearest" : "linear, nearest or trilinear");
}

Texture read_texture(Fields fields, const Context& context) {
  Texture texture;
  if (!context.vulkan() || fields.has("name")) texture.name = fields.text("name");
  if (context.vulkan() || fields.has("binding")) {
    texture.binding = fields.integer("binding", 0, kMaxBinding);
  }
  texture.sampler = fields.integer_or("sampler_binding", 0, kMaxBinding, -1);
  texture.width = fields.integer("width", 1, kMaxSide);
  texture.height = fields.integer("height", 1, kMaxSide);
  texture.filter = read_filter(fields, context);
  texture.texels =
      read_array<float>(context.folder / fields.text("file"), fields.path("file"),
                        std::uint64_t(texture.width) * std::uint64_t(texture.height) * 4);
  fields.finish();
  return texture;
}

Uniform read_uniform(Fields fields) {
  Uniform uniform{fields.text("name"), fields.numbers("values")};
  const std::set<std::size_t> sizes{1, 2, 3, 4, 9, 16};
  if (!sizes.contains(uniform.values.size())) {
    fields.fail("values", "1, 2, 3, 4, 9 or 16 numbers");
  }
  fields.finish();
  return uniform;
}

Shader read_shader(Fields& fields, const std::string& stage, const Context& context) {
  const std::string file = fields.text(stage), entry = stage + "_entry";
  Shader shader;
  shader.where = fmt::format("{} {}", fields.path(stage), file);
  shader.code = read_text(context.folder / file, fields.path(stage), kMaxShaderBytes);
  shader.entry = fields.text_or(entry, "main");
  if (!context.vulkan() && shader.entry != "main") fields.fail(entry, "main in GLSL");
  return shader;
}

Draw read_draw(Fields fields, const Context& context) {
  Draw draw;
  draw.where = fields.where();
  draw.name = fields.has("name") ? fields.text("name") : "";
  if (!draw.name.empty()) draw.where = fmt::format("{} {}", draw.where, draw.name);
  draw.vertex = read_shader(fields, "vertex", context);
  draw.fragment = read_shader(fields, "fragment", context);
  draw.output = context.folder / fields.text("output");
  if (context.vulkan()) {
    draw.uniform_binding = fields.integer_or("uniform_binding", 0, kMaxBinding, 0);
    if (fields.has("uniform_block")) {
      draw.uniform_block = read_text(context.folder / fields.text("uniform_block"),
                                     fields.path("uniform_block"), kMaxBlockBytes);
    }
  } else {
    for (Fields& f : fields.objects("uniforms", true)) draw.uniforms.push_back(read_uniform(f));
  }
  fields.finish();
  return draw;
}

/// Each binding of set 0 holds one thing.
void check_bindings(const Job& job) {
  std::set<int> taken;
  const auto take = [&](int binding, const std::string& what) {
    if (taken.insert(binding).second) return;
    throw Error(fmt::format("{} {} is used twice; each needs its own", what, binding));
  };
  for (std::size_t i = 0; i < job.textures.size(); ++i) {
    take(job.textures[i].binding, fmt::format("textures[{}].binding", i));
    if (job.textures[i].sampler >= 0) {
      take(job.textures[i].sampler, fmt::format("textures[{}].sampler_binding", i));
    }
  }
  for (const Draw& draw : job.draws) {
    if (!draw.uniform_block) continue;
    take(draw.uniform_binding, draw.where + ": uniform_binding");
    taken.erase(draw.uniform_binding);
  }
}

/// Each picture goes to a file of its own.
void check_outputs(const Job& job) {
  std::set<fs::path> taken;
  for (const Draw& draw : job.draws) {
    if (taken.insert(draw.output.lexically_normal()).second) continue;
    throw Error(fmt::format("{}: output {} is used twice", draw.where, draw.output.string()));
  }
}

/// Whether the optional member `key` is `chosen` instead of `usual`.
bool is_chosen(Fields& fields, const std::string& key, const std::string& usual,
               const std::string& chosen) {
  const std::string value = fields.text_or(key, usual);
  if (value != usual && value != chosen) fields.fail(key, fmt::format("{} or {}", usual, chosen));
  return value == chosen;
}

/// Members for GL and GLES only.
void read_gl_members(Fields& fields, Job& job) {
  job.hardware = is_chosen(fields, "driver", "software", "hardware");
  job.bytes = is_chosen(fields, "format", "float", "bytes");
  job.cull_back_faces = is_chosen(fields, "cull", "none", "back");
  job.samples = fields.integer_or("samples", 1, kMaxSamples, 1);
  job.frames = fields.integer_or("frames", 1, kMaxFrames, 0);
}

Job job_from(Fields fields, const fs::path& folder) {
  Job job;
  job.api = api_named(fields.text("api"), "api");
  const Context context{job.api, folder};
  job.width = fields.integer("width", 1, kMaxSide);
  job.height = fields.integer("height", 1, kMaxSide);
  if (!context.vulkan()) read_gl_members(fields, job);
  if (fields.has("mesh")) job.mesh = read_mesh(fields.object("mesh"), folder);
  const std::vector<Fields> textures = fields.objects("textures", true);
  if (textures.size() > kMaxTextures) {
    throw Error(fmt::format("textures must be at most {}, got {}", kMaxTextures, textures.size()));
  }
  for (const Fields& f : textures) job.textures.push_back(read_texture(f, context));
  for (const Fields& f : fields.objects("draws")) job.draws.push_back(read_draw(f, context));
  fields.finish();
  if (job.draws.empty()) throw Error("draws must hold at least one draw");
  if (context.vulkan()) check_bindings(job);
  check_outputs(job);
  return job;
}

}  // namespace

Api api_named(const std::string& name, const std::string& field) {
  const auto found = std::ranges::find(kApis, name, &ApiName::name);
  if (found != kApis.end()) return found->api;
  throw Error(fmt::format("{} must be gl, gles or vulkan, got {}", field, name));
}

Job read_job(const fs::path& file) {
  try {
    const Json job = Json::parse(read_file(file, "the job"));
    return job_from(Fields(job, ""), fs::absolute(file).parent_path());
  } catch (const Json::exception& e) {
    throw Error(fmt::format("{} is not JSON: {}", file.string(), e.what()));
  }
}

}  // namespace lumaknot::gpu
