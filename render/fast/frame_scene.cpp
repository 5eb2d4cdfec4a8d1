#include "render/fast/frame_scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/fast/near_uvs.h"

namespace lumaknot::fast {
namespace {

constexpr std::size_t kShortestRun = 1024, kMaxRuns = 64;

/// Lengths that fit single precision wherever a scene lies and however large it is: relative to the
/// eye, in units of the power of two nearest to the target's distance, so that nothing is rounded.
class EyeLengths {
  /// Beyond this, squared distances overflow single precision; in a scene of this size a lamp's
  /// parallax would show only in the last digit of a double.
  static constexpr double kFar = 1e15;

 public:
  explicit EyeLengths(const Camera& camera)
      : eye_(camera.position),
        scale_(std::exp2(-std::round(std::log2(length(camera.target - camera.position))))) {}

  Vec3d operator()(const Vec3d& position) const { return (position - eye_) * scale_; }

  Camera operator()(Camera camera) const {
    camera.target = (*this)(camera.target);
    camera.position = {};
    return camera;
  }

  Lighting<double> operator()(Lighting<double> lighting) const {
    lighting.eye_position = {};
    for (LightNumbers<double>& light : lighting.lights) {
      light.position = (*this)(light.position);
      light.linear /= scale_;
      light.quadratic /= scale_ * scale_;
      if (light.has_position && length(light.position) > kFar) light = from_afar(light);
    }
    return lighting;
  }

 private:
  /// The lamp as a directional light, with the intensity that arrives at the eye.
  static LightNumbers<double> from_afar(const LightNumbers<double>& lamp) {
    LightNumbers<double> light;
    light.has_position = light.has_falloff = false;
    light.direction = -normalize(lamp.position);
    light.color = arriving<double>(lamp, lamp.position, -light.direction);
    return light;
  }

  Vec3d eye_;
  double scale_;
};

/// The mesh's vertices as they are.
NearUvs as_it_is(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> vertices(mesh.positions.size());
  std::iota(vertices.begin(), vertices.end(), std::uint32_t{0});
  return {std::move(vertices),
          {mesh.uvs.begin(), mesh.uvs.end()},
          {mesh.triangles.begin(), mesh.triangles.end()}};
}

void copy_mesh(FrameData& data, const TriangleMesh& mesh, const EyeLengths& lengths) {
  const bool repeats = data.options.wrapping == Wrapping::kRepeat;
  const NearUvs corners = repeats ? near_uvs(mesh) : as_it_is(mesh);
  const std::size_t count = corners.vertices.size();
  data.vertex_count = count;
  data.triangle_count = corners.triangles.size();
  for (Bulk<double>* axis : {&data.xs, &data.ys, &data.zs}) axis->assign(count + kPadding, 0);
  data.records.resize(count);
  data.points.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t v = corners.vertices[i];
    const Vec3d p = lengths(mesh.positions[v]), &n = mesh.normals[v];
    const Vec2d& uv = corners.uvs[i];
    data.xs[i] = p.x, data.ys[i] = p.y, data.zs[i] = p.z;
    data.records[i] = {0, 0, 0, {float(n.x), float(n.y), float(n.z)}, {float(uv.u), float(uv.v)}};
  }
  for (std::size_t i = count; i < count + kPadding && count > 0; ++i) {
    data.xs[i] = data.xs[count - 1], data.ys[i] = data.ys[count - 1],
    data.zs[i] = data.zs[count - 1];
  }
  data.triangles.resize(data.triangle_count);
  std::ranges::transform(corners.triangles, data.triangles.begin(), [](const Triangle& t) {
    return std::array<std::uint32_t, 4>{t[0], t[1], t[2], 0};
  });
}

std::vector<Run> runs_of(std::size_t triangles) {
  const std::size_t length = std::max(kShortestRun, (triangles + kMaxRuns - 1) / kMaxRuns);
  std::vector<Run> runs;
  for (std::size_t first = 0; first < triangles; first += length) {
    Run run;
    run.first = std::uint32_t(first);
    run.last = std::uint32_t(std::min(first + length, triangles));
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace

FrameData frame_data(const Scene& scene, const Options& options) {
  FrameData data;
  const EyeLengths lengths(scene.view.camera);
  const Camera camera = lengths(scene.view.camera);
  data.width = scene.view.image.width;
  data.height = scene.view.image.height;
  data.columns = (data.width + kTile - 1) / kTile;
  data.rows = (data.height + kTile - 1) / kTile;
  data.options = options;
  data.pattern = sample_pattern(options.samples);
  data.projection = Projection(camera, data.width, data.height);
  const auto ray = [&](double x, double y) {
    return data.projection.to_world(data.projection.ray(x, y));
  };
  data.corner_ray = ray(0, 0);
  data.ray_x = ray(1, 0) - data.corner_ray;
  data.ray_y = ray(0, 1) - data.corner_ray;
  data.near = near_depth(camera);
  data.shot = {"final", Stage::kFinal, scene.view.material};
  data.lighting = lengths(lighting_of<double>(scene.view, scene.view.material));
  copy_mesh(data, scene.mesh, lengths);
  data.runs = runs_of(data.triangle_count);
  if (scene.view.material.rate == ShadingFrequency::kVertex) data.terms.resize(data.vertex_count);
  data.texture = make_mipmap(scene.texture, scene.view.material, options.wrapping,
                             options.filter == Filter::kTrilinear);
  return data;
}

}  // namespace lumaknot::fast
