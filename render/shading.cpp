#include "render/shading.h"

#include "render/texture.h"

namespace lumaknot {

Shading::Shading(const Scene& scene, const Shot& shot)
    : scene_(scene),
      shot_(shot),
      lighting_(lighting_of<double>(scene.view, shot.material)),
      needs_texture_(shot.stage == Stage::kTexture || shot.stage == Stage::kFinal) {}

Vec3d Shading::color(const Fragment& fragment) const {
  if (!fragment.covered()) return {};
  return color(fragment, needs_texture_ ? texture_color(scene_.texture, fragment.uv) : Vec3d{});
}

Vec3d Shading::color(const Fragment& fragment, const Vec3d& texture) const {
  if (!fragment.covered()) return {};
  const Vec3d value = needs_texture_ ? texture_value(texture, shot_.material) : Vec3d{};
  if (shot_.stage == Stage::kTexture) return stage_color(value, {}, lighting_, shot_);
  const bool at_vertices = shot_.material.rate == Rate::kVertex;
  const Terms<double> terms =
      at_vertices ? interpolated_terms(fragment) : terms_at({fragment.position, fragment.normal});
  return stage_color(value, terms, lighting_, shot_);
}

Terms<double> Shading::terms_at(const SurfacePoint<double>& point) const {
  return surface_terms(point, lighting_.eye_position, lighting_.lights, lighting_.model,
                       shot_.material);
}

Terms<double> Shading::interpolated_terms(const Fragment& fragment) const {
  Terms<double> sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = scene_.mesh.triangles[std::size_t(fragment.triangle)][i];
    const Terms<double> corner = terms_at({scene_.mesh.positions[v], scene_.mesh.normals[v]});
    sum.diffuse = sum.diffuse + corner.diffuse * fragment.weights[i];
    sum.specular = sum.specular + corner.specular * fragment.weights[i];
  }
  return sum;
}

}  // namespace lumaknot
