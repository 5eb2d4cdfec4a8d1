/// The light that reaches the eye from a point of the surface, over any number type.
#pragma once

#include "scene/spec.h"

namespace lumaknot {

/// A point of the surface as the pixel sees it.
template <class S>
struct SurfacePoint {
  Vec<S> position;  ///< world
  Vec<S> normal;    ///< world, as interpolated: shorter than one between vertices
};

/// The numbers of a light, as the number type sees them. Those that its kind lacks are not read.
template <class S>
struct LightNumbers {
  bool has_position = true, has_falloff = true, has_cone = false;
  Vec<S> position, direction;  ///< world; direction is unit, the way the light shines
  Vec<S> color;                ///< intensity times colour; grey in a space of brightness
  S constant{1}, linear{0}, quadratic{0};  ///< of the falloff
  S cos_outer{0}, cone_scale{1};           ///< 1 / (cos inner - cos outer)
};

/// The light that reaches the eye, before the weights of the material; grey where all light is
/// white.
template <class S>
struct Terms {
  Vec<S> diffuse;   ///< L_D
  Vec<S> specular;  ///< L_S
};

template <class S>
S diffuse_term(Model model, const Directions<S>& d, const ModelParameters<S>& parameters) {
  return with_diffuse(model, parameters,
                      [&](auto term, const auto&... p) { return term.value(d, p...); });
}

template <class S>
S specular_term(Model model, const Directions<S>& d, const ModelParameters<S>& parameters) {
  return with_highlight(model, parameters,
                        [&](auto term, const auto&... p) { return term.value(d, p...); });
}

/// What of `light` arrives along `to_light` (surface to light, not unit; unused without position),
/// whose unit vector is `l`: its colour times falloff times cone.
template <class S>
Vec<S> arriving(const LightNumbers<S>& light, const Vec<S>& to_light, const Vec<S>& l) {
  Vec<S> color = light.color;
  if (light.has_position && light.has_falloff) {
    const S squared = named("distance2", dot(to_light, to_light));
    const S weakening = light.constant + light.linear * sqrt(squared) + light.quadratic * squared;
    color = color * (S(1) / max(weakening, S(1e-6)));
  }
  if (light.has_cone) {
    const S cosine = S(-1) * dot(l, light.direction);
    const S edge = named("cone_edge", saturate((cosine - light.cos_outer) * light.cone_scale));
    color = color * (edge * edge * (S(3) - S(2) * edge));
  }
  return color;
}

/// The terms of all lights at `point`, summed.
template <class S>
Terms<S> surface_terms(const SurfacePoint<S>& point, const Vec<S>& eye_position,
                       const std::vector<LightNumbers<S>>& lights,
                       const ModelParameters<S>& parameters, const Material& material) {
  Terms<S> sum{grey(S(0)), grey(S(0))};
  const Vec<S> v = named("to_eye", unit(eye_position - point.position));
  const Vec<S> n =
      material.normal == NormalUse::kUnit ? named("n", unit(point.normal)) : point.normal;
  for (const LightNumbers<S>& light : lights) {
    const Vec<S> to_light =
        light.has_position ? light.position - point.position : light.direction * S(-1);
    const Vec<S> l = named("to_light", light.has_position ? unit(to_light) : to_light);
    const Directions<S> d{n, l, v, named("n_dot_l", dot(n, l))};
    const S diffuse = diffuse_term(material.model, d, parameters);
    S specular = specular_term(material.model, d, parameters);
    if (material.highlights == Highlights::kGated) {
      specular = select_less(S(0), d.n_dot_l, specular, S(0));
    }
    const Vec<S> color = arriving(light, to_light, l);
    sum.diffuse = sum.diffuse + color * diffuse;
    sum.specular = sum.specular + color * specular;
  }
  return sum;
}

}  // namespace lumaknot
