#include "diagnosis/surface_colors.h"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>

#include "diagnosis/shadows.h"
#include "diagnosis/texturing.h"
#include "render/triangle.h"
#include "shaders/formulas/lighting.h"

namespace lumaknot::diagnosis {
namespace {

Vec3d flat_normal(const TriangleMesh& mesh, const Fragment& f) {
  const Vec3d normal = triangle_normal(mesh, mesh.triangles[std::size_t(f.triangle)]);
  return normal == Vec3d{} ? f.normal : normal;
}

/// The light that reaches the eye from each fragment.
class Light {
 public:
  explicit Light(const Setup& setup)
      : setup_(setup), lighting_(lighting_of<double>(setup.view, setup.view.material)) {
    if (setup.shadows) shadows_.emplace(*setup.mesh, setup.view.lights);
  }

  const Lighting<double>& numbers() const { return lighting_; }

  Terms<double> at(const Fragment& f) const {
    if (setup_.view.material.rate != ShadingFrequency::kVertex) {
      return at(f.position, normal_of(f));
    }
    Terms<double> sum{{}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = setup_.mesh->triangles[std::size_t(f.triangle)][i];
      const Terms<double> corner = at(setup_.mesh->positions[v], setup_.mesh->normals[v]);
      sum.diffuse = sum.diffuse + corner.diffuse * f.weights[i];
      sum.specular = sum.specular + corner.specular * f.weights[i];
    }
    return sum;
  }

 private:
  Vec3d normal_of(const Fragment& f) const {
    const NormalUse& use = setup_.normals;
    Vec3d normal = use.flat ? flat_normal(*setup_.mesh, f) : f.normal;
    if (use.inverted) normal = -normal;
    const bool away = dot(normal, setup_.view.camera.position - f.position) < 0;
    return use.turned && away ? -normal : normal;
  }

  Terms<double> at(const Vec3d& position, const Vec3d& normal) const {
    const SurfacePoint<double> point{position, normal};
    if (!shadows_) return terms(point, lighting_.lights);
    std::vector<LightNumbers<double>> seen;
    for (std::size_t i = 0; i < lighting_.lights.size(); ++i) {
      if (!shadows_->hides(i, position)) seen.push_back(lighting_.lights[i]);
    }
    return terms(point, seen);
  }

  Terms<double> terms(const SurfacePoint<double>& point,
                      const std::vector<LightNumbers<double>>& lights) const {
    return surface_terms(point, lighting_.eye_position, lights, lighting_.parameters,
                         setup_.view.material);
  }

  const Setup& setup_;
  Lighting<double> lighting_;
  std::optional<Shadows> shadows_;
};

}  // namespace

Drawn surface_colors(const Setup& setup, const Grid<Fragment>& fragments) {
  const Texturing texturing(setup);
  const Light light(setup);
  const Shot shot{"diagnosis", setup.stage, setup.view.material};
  const std::size_t count = fragments.pixels.size();
  Drawn drawn{std::vector<Vec3d>(count), std::vector<double>(count)};
  oneapi::tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const Fragment& f = fragments.pixels[i];
    if (!f.covered()) return;
    const bool textured = setup.stage == Stage::kTexture || setup.stage == Stage::kFinal;
    const Vec3d texel = textured ? texture_value(texturing.color(f), shot.material) : Vec3d{};
    const Terms<double> terms =
        setup.stage == Stage::kTexture ? Terms<double>{{}, {}} : light.at(f);
    drawn.colors[i] = stage_color(texel, terms, light.numbers(), shot);
    drawn.coverage[i] = 1;
  });
  return drawn;
}

}  // namespace lumaknot::diagnosis
