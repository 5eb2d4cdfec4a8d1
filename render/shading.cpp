#include "render/shading.h"

#include "render/texture.h"
#include "shaders/graph/half.h"

namespace lumaknot {
namespace {

double as_double(double x) { return x; }
double as_double(Half x) { return double(x.value); }

}  // namespace

template <class S>
ShadingIn<S>::ShadingIn(const Scene& scene, const Shot& shot)
    : scene_(scene),
      shot_(shot),
      lighting_(lighting_of<S>(scene.view, shot.material)),
      needs_texture_(shot.stage == Stage::kTexture || shot.stage == Stage::kFinal) {}

template <class S>
Vec3d ShadingIn<S>::color(const Fragment& fragment) const {
  if (!fragment.covered()) return {};
  return color(fragment, needs_texture_ ? texture_color(scene_.texture, fragment.uv) : Vec3d{});
}

template <class S>
Vec3d ShadingIn<S>::color(const Fragment& fragment, const Vec3d& texture) const {
  if (!fragment.covered()) return {};
  const Vec<S> value =
      constant_vec<S>(needs_texture_ ? texture_value(texture, shot_.material) : Vec3d{});
  Terms<S> terms;
  if (shot_.stage != Stage::kTexture) {
    const bool at_vertices = shot_.material.rate == ShadingFrequency::kVertex;
    terms =
        at_vertices ? interpolated_terms(fragment) : terms_at(fragment.position, fragment.normal);
  }
  const Vec<S> shaded = stage_color(value, terms, lighting_, shot_);
  return {as_double(shaded.x), as_double(shaded.y), as_double(shaded.z)};
}

template <class S>
Terms<S> ShadingIn<S>::terms_at(const Vec3d& position, const Vec3d& normal) const {
  const SurfacePoint<S> point{constant_vec<S>(position), constant_vec<S>(normal)};
  return surface_terms(point, lighting_.eye_position, lighting_.lights, lighting_.parameters,
                       shot_.material);
}

template <class S>
Terms<S> ShadingIn<S>::interpolated_terms(const Fragment& fragment) const {
  Terms<S> sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = scene_.mesh.triangles[std::size_t(fragment.triangle)][i];
    const Terms<S> corner = terms_at(scene_.mesh.positions[v], scene_.mesh.normals[v]);
    sum.diffuse = sum.diffuse + corner.diffuse * S(fragment.weights[i]);
    sum.specular = sum.specular + corner.specular * S(fragment.weights[i]);
  }
  return sum;
}

template class ShadingIn<double>;
template class ShadingIn<Half>;

}  // namespace lumaknot
