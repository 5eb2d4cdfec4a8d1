#include "validate/renderers/gpu_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "exporters/image/baked_texture.h"
#include "math/angle.h"
#include "shaders/languages/emit.h"
#include "system/atomic_file.h"
#include "validate/renderers/depth_range.h"
#include "validate/renderers/job_files.h"
#include "validate/renderers/spirv.h"

namespace lumaknot::validate {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Matrix = std::array<double, 16>;  // column-major

constexpr std::string_view kGpuFolder = "lumaknot-gpu's folder";

/// Where Vulkan's shaders find a texture; HLSL's, as compile_spirv() shifts them, also its sampler.
struct Binding {
  int texture, sampler;
};
constexpr Binding kColor{1, 3}, kAxes{2, 4};

Json write_texture(const fs::path& folder, const std::string& name, const TextureImage& texture,
                   const Binding& binding, bool has_samplers) {
  Json json = write_job_texture(folder, name, texture);
  json["name"] = name;
  json["binding"] = binding.texture;
  json["filter"] = "linear";
  if (has_samplers) json["sampler_binding"] = binding.sampler;
  return json;
}

Json write_textures(const fs::path& folder, const Texture& texture, std::span<const Shot> shots,
                    bool has_samplers) {
  Json list = Json::array();
  const auto* image = std::get_if<TextureImage>(&texture);
  if (!image) return list;
  list.push_back(write_texture(folder, "color_texture", *image, kColor, has_samplers));
  const auto baked =
      std::ranges::find(shots, Form::kBaked, [](const Shot& s) { return s.material.form; });
  if (baked != shots.end()) {
    list.push_back(write_texture(folder, "axes_texture", baked_texture(*image, baked->material),
                                 kAxes, has_samplers));
  }
  return list;
}

/// From the world to clip space. Vulkan: y downwards and z from 0 to 1.
Matrix world_view_projection(const Scene& scene, bool is_vulkan) {
  const Camera& camera = scene.view.camera;
  const CameraFrame frame = camera_frame(camera);
  const Interval<double> range = depth_range(scene.mesh, camera, scene.view.image);
  const double near = range.min, far = range.max;
  const double up = 1 / std::tan(camera.fov_degrees * kPi / 360);
  const double right = up * scene.view.image.height / scene.view.image.width;
  const double z = is_vulkan ? far / (far - near) : (far + near) / (far - near);
  const double z0 = (is_vulkan ? 1 : 2) * -far * near / (far - near);
  const Vec3d rows[4] = {frame.right * right, frame.up * (is_vulkan ? -up : up), -frame.back * z,
                         -frame.back};
  const double last[4] = {0, 0, z0, 0};
  Matrix matrix{};
  for (std::size_t row = 0; row < 4; ++row) {
    const auto c = components(rows[row]);
    for (std::size_t column = 0; column < 3; ++column) matrix[column * 4 + row] = c[column];
    matrix[12 + row] = last[row] - dot(rows[row], camera.position);
  }
  return matrix;
}

constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Json uniforms_json(const Shader& shader, const Matrix& projection) {
  Json list{{{"name", "world"}, {"values", kIdentity}},
            {{"name", "world_inverse_transpose"}, {"values", kIdentity}},
            {{"name", "world_view_projection"}, {"values", projection}}};
  for (const ShaderParameter& p : shader.parameters) {
    const Json values = p.is_vector ? Json(components(p.value)) : Json::array({p.value.x});
    list.push_back({{"name", p.name}, {"values", values}});
  }
  return list;
}

std::string block_bytes(const Shader& shader, const Matrix& projection) {
  const std::vector<BlockEntry> entries = parameter_block(shader);
  const int end = entries.empty() ? kMatrixBytes : entries.back().offset + 12;
  std::vector<float> values(std::size_t(end + 15) / 16 * 4);
  std::size_t at = 0;
  for (const Matrix& matrix : {kIdentity, kIdentity, projection}) {
    for (const double v : matrix) values[at++] = float(v);
  }
  for (const BlockEntry& entry : entries) {
    const auto c = components(entry.parameter.value);
    const std::size_t count = entry.parameter.is_vector ? 3 : 1;
    for (std::size_t i = 0; i < count; ++i) values[std::size_t(entry.offset) / 4 + i] = float(c[i]);
  }
  return float_bytes(values);
}

/// Writes a shot's two stages; returns their entry of the job.
Json write_draw(const fs::path& folder, const ShaderJob& job, Language language,
                const Matrix& projection, const Programs& programs) {
  const Shader shader = make_shader(job);
  const Emission files = emit(job, language);
  const bool is_hlsl = language == Language::kHlsl;
  Json draw{{"name", job.name}, {"output", job.name + ".bin"}};
  const auto add_stage = [&](std::string_view stage, const std::string& text, bool is_fragment) {
    const std::string file = fmt::format("{}.{}", job.name, stage);
    const std::string entry = is_hlsl ? fmt::format("{}_main", stage) : "main";
    const bool is_source = backend_of(language).api != "vulkan";
    write_file(folder / file,
               is_source ? text : compile_spirv(programs, text, {is_hlsl, is_fragment, entry}),
               kGpuFolder);
    draw[std::string(stage)] = file;
    draw[fmt::format("{}_entry", stage)] = entry;
  };
  add_stage("vertex", files[0].text, false);
  add_stage("fragment", files[is_hlsl ? 0 : 1].text, true);
  if (backend_of(language).api != "vulkan") {
    draw["uniforms"] = uniforms_json(shader, projection);
    return draw;
  }
  write_file(folder / (job.name + ".block"), block_bytes(shader, projection), kGpuFolder);
  draw["uniform_block"] = job.name + ".block";
  draw["uniform_binding"] = 0;
  return draw;
}

/// What a timed job says beyond a drawn one.
void add_timing(const GpuTiming& timing, Json& json) {
  json["driver"] = timing.hardware ? "hardware" : "software";
  json["frames"] = timing.frames;
  json["samples"] = timing.samples;
  json["cull"] = timing.cull_back_faces ? "back" : "none";
  json["format"] = "bytes";
  if (!timing.trilinear) return;
  for (Json& texture : json["textures"]) texture["filter"] = "trilinear";
}

}  // namespace

void write_gpu_job(const fs::path& folder, const Scene& scene, std::span<const Shot> shots,
                   Language language, const Programs& programs, const GpuTiming* timing) {
  const Matrix projection = world_view_projection(scene, backend_of(language).api == "vulkan");
  Json json{{"api", backend_of(language).api},
            {"width", scene.view.image.width},
            {"height", scene.view.image.height}};
  json["mesh"] = write_job_mesh(folder, scene.mesh);
  json["textures"] = write_textures(folder, scene.texture, shots, language == Language::kHlsl);
  for (const Shot& shot : shots) {
    ShaderJob job;
    job.name = shot.name;
    job.view = scene.view;
    job.shot = shot;
    if (const auto* color = std::get_if<Vec3d>(&scene.texture)) job.color = *color;
    json["draws"].push_back(write_draw(folder, job, language, projection, programs));
  }
  if (timing) add_timing(*timing, json);
  write_file(folder / "job.json", json.dump(1), kGpuFolder);
}

Image read_gpu_image(const fs::path& path, int width, int height) {
  const std::string bytes = read_file(path, "lumaknot-gpu");
  Image image(width, height);
  static_assert(sizeof(RgbaPixel) == 16);
  if (bytes.size() != image.pixels.size() * sizeof(RgbaPixel)) {
    throw std::runtime_error(fmt::format("{} holds {} bytes, not {} x {} pixels",
                                         path.filename().string(), bytes.size(), width, height));
  }
  std::memcpy(image.pixels.data(), bytes.data(), bytes.size());
  return image;
}

}  // namespace lumaknot::validate
