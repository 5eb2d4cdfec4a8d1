#include "validate/renderers/povray_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "exporters/povray/scene.h"
#include "shaders/formulas/lighting.h"

namespace lumaknot::validate {
namespace {

/// Terms are kept in 16 bits: divided by more, their steps would show.
constexpr double kMaxBrightness = 32;

/// A lower bound of the distance from `point` to the mesh: each triangle lies within a ball about
/// its first corner.
double distance_bound(const TriangleMesh& mesh, const Vec3d& point) {
  double min = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles) {
    const Vec3d& corner = mesh.positions[t[0]];
    const double radius =
        std::max(length(mesh.positions[t[1]] - corner), length(mesh.positions[t[2]] - corner));
    min = std::min(min, length(corner - point) - radius);
  }
  return std::max(min, 0.0);
}

View dimmed(View view, double brightness) {
  for (Light& light : view.lights) {
    std::visit([&](auto& l) { l.color.intensity /= brightness; }, light);
  }
  return view;
}

class Planner {
 public:
  Planner(const Scene& scene, const std::string& prefix, std::string_view mesh)
      : scene_(scene), prefix_(prefix), mesh_(mesh) {}

  void add(const Shot& shot) {
    PovShot planned;
    if (const auto missing = povray::pov_missing_term(scene_.view, shot)) {
      planned.why = *missing;
    } else if (const auto shortfall = povray::pov_shortfall(scene_.view, shot)) {
      compose(shot, *shortfall, planned);
    } else {
      planned.frame = frame(scene_.view, shot);
    }
    plan_.shots.push_back(std::move(planned));
  }

  PovPlan plan() && { return std::move(plan_); }

 private:
  std::size_t frame(const View& view, const Shot& shot) {
    const std::string text = povray::pov_scene(view, scene_.texture, shot, prefix_, mesh_);
    const auto found = std::ranges::find(plan_.frames, text);
    const auto index = std::size_t(found - plan_.frames.begin());
    if (found == plan_.frames.end()) plan_.frames.push_back(text);
    return index;
  }

  void compose(const Shot& shot, const std::string& shortfall, PovShot& planned) {
    const double light = brightest_light(scene_.mesh, scene_.view, shot.material.space);
    if (light > kMaxBrightness) {
      planned.why = fmt::format(
          "{}, and its light, up to {:.3g}, is too much for terms in 16 bits; "
          "nearest: an intensity so much lower that it is {} at most",
          shortfall, light, kMaxBrightness);
      return;
    }
    planned.why = shortfall;
    planned.parts = parts(shot, std::max(light, 1.0));
  }

  PovParts parts(const Shot& shot, double brightness) {
    const View view = dimmed(scene_.view, brightness);
    const auto stage = [&](Stage s) {
      Shot term = shot;
      term.stage = s;
      return frame(s == Stage::kTexture ? scene_.view : view, term);
    };
    PovParts parts;
    parts.texture = stage(Stage::kTexture);
    parts.brightness = brightness;
    if (povray::needs_diffuse(scene_.view, shot)) parts.diffuse = stage(Stage::kDiffuse);
    if (povray::needs_specular(scene_.view, shot)) parts.specular = stage(Stage::kSpecular);
    return parts;
  }

  const Scene& scene_;
  std::string prefix_;
  std::string_view mesh_;
  PovPlan plan_;
};

}  // namespace

double brightest_light(const TriangleMesh& mesh, const View& view, Space space) {
  Material material;
  material.space = space;
  double sum = 0;
  for (const LightNumbers<double>& light : lighting_of<double>(view, material).lights) {
    const double d = light.has_position ? distance_bound(mesh, light.position) : 0;
    const double weakening =
        light.has_position ? light.constant + light.linear * d + light.quadratic * d * d : 1;
    sum += largest_component(light.color) / std::max(weakening, 1e-6);  // as the formula guards it
  }
  return sum;
}

PovPlan plan_povray(const Scene& scene, std::span<const Shot> shots, const std::string& prefix,
                    std::string_view mesh) {
  Planner planner(scene, prefix, mesh);
  for (const Shot& shot : shots) planner.add(shot);
  return std::move(planner).plan();
}

}  // namespace lumaknot::validate
