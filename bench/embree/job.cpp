#include "bench/embree/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/json.h"
#include "system/atomic_file.h"
#include "validate/gpu/fields.h"
#include "validate/gpu/files.h"

namespace lumaknot::embree {
namespace {

namespace fs = std::filesystem;
using gpu::Fields;

constexpr int kMaxSide = 65'536, kMaxFrames = 1'000'000, kMaxThreads = 1024;

std::int32_t packed(const float* rgba) {
  std::uint32_t all = 0;
  for (int c = 3; c >= 0; --c) {
    all = all << 8 | std::uint32_t(std::lround(std::clamp(rgba[c], 0.0f, 1.0f) * 255));
  }
  return std::int32_t(all);
}

PackedTexture read_texture(Fields fields, const fs::path& folder) {
  PackedTexture texture;
  texture.width = fields.integer("width", 1, kMaxSide);
  texture.height = fields.integer("height", 1, kMaxSide);
  const std::uint64_t texels = std::uint64_t(texture.width) * std::uint64_t(texture.height);
  const std::vector<float> values =
      gpu::read_array<float>(folder / fields.text("file"), fields.path("file"), texels * 4);
  fields.finish();
  texture.texels.reserve(texels);
  for (std::uint64_t i = 0; i < texels; ++i) texture.texels.push_back(packed(&values[i * 4]));
  return texture;
}

Draw read_draw(Fields fields, const fs::path& folder) {
  Draw draw;
  draw.name = fields.text("name");
  const std::string scene = fields.text("scene");
  const SceneSpec spec = scene_from_json(read_file(folder / scene, fields.path("scene")), scene);
  draw.view = spec.view;
  if (const auto* plain = std::get_if<PlainColor>(&spec.texture)) draw.color = plain->rgb;
  draw.output = folder / fields.text("output");
  fields.finish();
  if (draw.view.material.form == Form::kBaked ||
      draw.view.material.rate == ShadingFrequency::kVertex) {
    throw Error(fmt::format("{}: only per-pixel light and textures in r'g'b' are drawn", scene));
  }
  return draw;
}

Job job_from(Fields fields, const fs::path& folder) {
  Job job;
  job.frames = fields.integer("frames", 1, kMaxFrames);
  job.samples = fields.integer_or("samples", 1, 16, 1);
  job.threads = fields.integer_or("threads", 0, kMaxThreads, 0);
  job.mesh = gpu::read_mesh(fields.object("mesh"), folder);
  if (fields.has("texture")) job.texture = read_texture(fields.object("texture"), folder);
  for (const Fields& f : fields.objects("draws")) job.draws.push_back(read_draw(f, folder));
  fields.finish();
  if (job.draws.empty()) throw Error("draws must hold at least one draw");
  return job;
}

}  // namespace

Job read_job(const fs::path& file) {
  try {
    const gpu::Json job = gpu::Json::parse(read_file(file, "the job"));
    return job_from(Fields(job, ""), fs::absolute(file).parent_path());
  } catch (const gpu::Json::exception& e) {
    throw Error(fmt::format("{} is not JSON: {}", file.string(), e.what()));
  }
}

}  // namespace lumaknot::embree
