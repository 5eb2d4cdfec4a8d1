/// Lighting, each formula once, over any number type. Symbols and equation numbers: Kotsarenko and
/// Ramos, "Alternative Diffuse Lighting and Specular Reflection Approach Using YIQ Color Space".
#pragma once

#include "scene/shot.h"
#include "shaders/number.h"
#include "shaders/yiq.h"

namespace lumaknot {

/// A point of the surface as the pixel sees it.
template <class S>
struct SurfacePoint {
  Vec<S> position;  ///< world
  Vec<S> normal;    ///< world, as interpolated: shorter than one between vertices
  Vec<S> texture;   ///< T, encoded r'g'b'
};

/// The numbers of the light and of the material, as the number type sees them.
template <class S>
struct Lighting {
  Vec<S> eye_position, light_position;  ///< world
  S ambient, diffuse, specular, shininess, luma_offset;
};

/// The scalar terms of the lighting.
template <class S>
struct Terms {
  S diffuse;   ///< L_D
  S specular;  ///< L_S
};

/// L_D = max(L.n, 0) (eq. 1) and L_S = max(v.R, 0)^k, R = 2 (L.n) n - L (eq. 2), unweighted.
/// Nothing gates the highlight where L.n < 0, as in the paper.
template <class S>
Terms<S> phong_terms(const SurfacePoint<S>& point, const Lighting<S>& lighting, NormalUse use) {
  const Vec<S> to_eye = named("to_eye", unit(lighting.eye_position - point.position));
  const Vec<S> to_light = named("to_light", unit(lighting.light_position - point.position));
  const Vec<S> n = use == NormalUse::kUnit ? named("n", unit(point.normal)) : point.normal;
  const S n_dot_l = named("n_dot_l", dot(n, to_light));
  const Vec<S> reflection = named("reflection", unit(n * (S(2) * n_dot_l) - to_light));
  const S r_dot_v = named("r_dot_v", max(dot(reflection, to_eye), S(0)));
  return {max(n_dot_l, S(0)), power(r_dot_v, lighting.shininess)};
}

/// The lit colour: eq. 3 in space rgb, eq. 6-8 in YIQ; with `Clamp::kTable1` the clamps of Table 1.
template <class S>
Vec<S> lit_color(const Vec<S>& texture, const Terms<S>& terms, const Lighting<S>& lighting,
                 Space space, Clamp clamp) {
  const bool clamped = clamp == Clamp::kTable1;
  const S diffuse = lighting.diffuse * (clamped ? saturate(terms.diffuse) : terms.diffuse);
  const S sum = diffuse + lighting.ambient;
  const S light = named("light", clamped ? saturate(sum) : sum);
  const S highlight = named("highlight", lighting.specular * terms.specular);
  Vec<S> color = texture * light + make_vec(highlight, highlight, highlight);
  if (space == Space::kYiq) {
    Yiq<S> yiq = yiq_from_rgb<S>(texture);
    yiq.y = named("lit_luma", yiq.y * light + highlight + lighting.luma_offset);
    color = rgb_from_yiq(yiq);
  }
  return clamped ? saturate(color) : color;
}

/// What `shot` shows at `point`.
template <class S>
Vec<S> stage_color(const SurfacePoint<S>& point, const Lighting<S>& lighting, const Shot& shot) {
  if (shot.stage == Stage::kTexture) return point.texture;
  const Terms<S> terms = phong_terms(point, lighting, shot.material.normal);
  if (shot.stage == Stage::kDiffuse) return make_vec(terms.diffuse, terms.diffuse, terms.diffuse);
  if (shot.stage == Stage::kSpecular) {
    return make_vec(terms.specular, terms.specular, terms.specular);
  }
  return lit_color(point.texture, terms, lighting, shot.material.space, shot.material.clamp);
}

/// The numbers of `view`, its material replaced by the shot's.
template <class S>
Lighting<S> lighting_of(const View& view, const Material& material) {
  return {constant_vec<S>(view.camera.position),
          constant_vec<S>(view.light.position),
          S(view.ambient),
          S(material.diffuse),
          S(material.specular),
          S(material.shininess),
          S(material.luma_offset)};
}

}  // namespace lumaknot
