/// The lighting models: what one light sends to the eye, each formula once, over any number type.
/// Symbols: Kotsarenko and Ramos, "Alternative Diffuse Lighting and Specular Reflection Approach
/// Using YIQ Color Space"; n, l, v, h: unit normal, to the light, to the eye, half way between.
#pragma once

#include "scene/spec.h"
#include "shaders/graph/number.h"

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

/// The numbers that the lighting models read, the material's.
template <class S>
struct ModelNumbers {
  S shininess{55}, roughness{0.3}, reflectance{0.04}, darkness{1};
};

/// The light that reaches the eye, before the weights of the material; grey where all light is
/// white.
template <class S>
struct Terms {
  Vec<S> diffuse;   ///< L_D
  Vec<S> specular;  ///< L_S
};

/// The directions at a point that a lighting model asks for.
template <class S>
struct Directions {
  Vec<S> n, l, v;
  S n_dot_l;
};

/// L_S = max(v.R, 0)^k with R = 2 (L.n) n - L (eq. 2).
template <class S>
S phong_highlight(const Directions<S>& d, const S& shininess) {
  const Vec<S> reflection = named("reflection", unit(d.n * (S(2) * d.n_dot_l) - d.l));
  return power(named("r_dot_v", max(dot(reflection, d.v), S(0))), shininess);
}

/// max(n.h, 0)^k: J. Blinn, "Models of light reflection for computer synthesized pictures",
/// SIGGRAPH 1977.
template <class S>
S blinn_highlight(const Directions<S>& d, const S& shininess) {
  const Vec<S> half = named("half_way", unit(d.l + d.v));
  return power(named("n_dot_h", max(dot(d.n, half), S(0))), shininess);
}

/// n.l (n.l n.v)^(k-1): M. Minnaert, "The reciprocity principle in lunar photometry", Astrophysical
/// Journal 93, 1941. Both cosines at least 0, their product at least 1e-4: below it the formula
/// grows without bound where k < 1.
template <class S>
S minnaert_diffuse(const Directions<S>& d, const S& darkness) {
  const S lit = max(d.n_dot_l, S(0));
  const S seen = named("n_dot_v", max(dot(d.n, d.v), S(0)));
  return lit * power(max(lit * seen, S(1e-4)), darkness - S(1));
}

/// n.l (A + B max(0, cos(phi)) sin(a) tan(b)): M. Oren and S. Nayar, "Generalization of Lambert's
/// reflectance model", SIGGRAPH 1994, eq. 30. sin(a) sin(b) cos(phi) is l.v - n.l n.v, so no
/// angle is computed.
template <class S>
S oren_nayar_diffuse(const Directions<S>& d, const S& sigma) {
  const S variance = named("variance", sigma * sigma);
  const S a = S(1) - S(0.5) * variance / (variance + S(0.33));
  const S b = S(0.45) * variance / (variance + S(0.09));
  const S lit = max(d.n_dot_l, S(0));
  const S n_dot_v = named("n_dot_v", dot(d.n, d.v));
  const S across = named("across", max(dot(d.l, d.v) - d.n_dot_l * n_dot_v, S(0)));
  return lit * (a + b * across / max(max(lit, n_dot_v), S(1e-3)));
}

/// pi D V F n.l: R. Cook and K. Torrance, "A reflectance model for computer graphics", 1982, with
/// the GGX distribution (B. Walter et al., "Microfacet models for refraction through rough
/// surfaces", EGSR 2007), Smith's height-correlated visibility (E. Heitz, JCGT 2014) and Schlick's
/// Fresnel term (1994). alpha = roughness^2. The factor pi is the convention in which a white
/// Lambert surface answers n.l. 1 - (n.h)^2 is taken as |n x h|^2, which stays exact in float.
template <class S>
S cook_torrance_highlight(const Directions<S>& d, const S& roughness, const S& reflectance) {
  const S alpha = named("alpha", max(roughness * roughness, S(1e-3)));
  const S alpha2 = named("alpha2", alpha * alpha);
  const Vec<S> half = named("half_way", unit(d.l + d.v));
  const S n_dot_h = named("n_dot_h", max(dot(d.n, half), S(0)));
  const Vec<S> n_cross_h = named("n_cross_h", cross(d.n, half));
  // Of unit vectors it is at least this; without a normal or with l = -v there is no half way.
  const S smallest = min(alpha2, S(1));
  const S spread =
      named("spread", max(alpha2 * n_dot_h * n_dot_h + dot(n_cross_h, n_cross_h), smallest));
  const S lit = named("lit", max(d.n_dot_l, S(0)));
  // An eye below the surface's horizon sees no highlight; there l + v may be any small vector.
  const S n_dot_v = named("n_dot_v", dot(d.n, d.v));
  const S seen = named("seen", max(n_dot_v, S(1e-3)));
  const S above = saturate(n_dot_v * S(1e3));
  const S shadowed = lit * sqrt(max(seen * seen * (S(1) - alpha2) + alpha2, S(0)));
  const S masked = seen * sqrt(max(lit * lit * (S(1) - alpha2) + alpha2, S(0)));
  const S away = named("away", S(1) - max(dot(d.v, half), S(0)));
  const S away2 = away * away;
  const S fresnel = reflectance + (S(1) - reflectance) * (away2 * away2 * away);
  return above * alpha2 * fresnel * lit * S(0.5) / (spread * spread * (shadowed + masked));
}

template <class S>
S diffuse_term(Model model, const Directions<S>& d, const ModelNumbers<S>& numbers) {
  if (model == Model::kMinnaert) return minnaert_diffuse(d, numbers.darkness);
  if (model == Model::kOrenNayar) return oren_nayar_diffuse(d, numbers.roughness);
  return max(d.n_dot_l, S(0));  // Lambert, eq. 1
}

template <class S>
S specular_term(Model model, const Directions<S>& d, const ModelNumbers<S>& numbers) {
  if (model == Model::kBlinnPhong) return blinn_highlight(d, numbers.shininess);
  if (model == Model::kCookTorrance) {
    return cook_torrance_highlight(d, numbers.roughness, numbers.reflectance);
  }
  return phong_highlight(d, numbers.shininess);
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
                       const std::vector<LightNumbers<S>>& lights, const ModelNumbers<S>& numbers,
                       const Material& material) {
  Terms<S> sum{grey(S(0)), grey(S(0))};
  const Vec<S> v = named("to_eye", unit(eye_position - point.position));
  const Vec<S> n =
      material.normal == NormalUse::kUnit ? named("n", unit(point.normal)) : point.normal;
  for (const LightNumbers<S>& light : lights) {
    const Vec<S> to_light =
        light.has_position ? light.position - point.position : light.direction * S(-1);
    const Vec<S> l = named("to_light", light.has_position ? unit(to_light) : to_light);
    const Directions<S> d{n, l, v, named("n_dot_l", dot(n, l))};
    const S diffuse = diffuse_term(material.model, d, numbers);
    S specular = specular_term(material.model, d, numbers);
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
