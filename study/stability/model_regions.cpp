// Surface models with a division.
#include <algorithm>
#include <array>

#include "math/angle.h"
#include "study/stability/regions.h"
#include "study/stability/test_scenes.h"
#include "study/stability/textbook.h"

namespace lumaknot::stability {
namespace {

/// Some unit normals in float.
std::vector<Vec3<float>> normals() {
  std::vector<Vec3<float>> list;
  for (int i = 0; i < 40; ++i) {
    const double z = 1 - (i + 0.5) / 20, a = 2.4 * i, r = std::sqrt(1 - z * z);
    list.push_back(normalize(constant_vec<float>(Vec3d{r * std::cos(a), r * std::sin(a), z})));
  }
  return list;
}

/// A light 60 degrees from `n` and an eye `angle` radians from it.
template <class S>
Directions<S> seen_from_above(const Vec3<float>& normal, double angle) {
  const Vec3d n{normal.x, normal.y, normal.z};
  const Vec3d x = normalize(cross(n, Vec3d{0.3, 0.5, 0.8})), y = cross(n, x);
  const Vec3d l = n * std::cos(60 * kDegree) + (x * 0.6 + y * 0.8) * std::sin(60 * kDegree);
  const Vec3d v = n * std::cos(angle) + x * std::sin(angle);
  const Vec<S> ns = constant_vec<S>(n), ls = constant_vec<S>(l);
  return {ns, ls, constant_vec<S>(v), dot(ns, ls)};
}

constexpr double kSigma = 0.6;

template <class Diffuse>
double oren_nayar_error(double angle, Diffuse diffuse) {
  double largest = 0;
  for (const Vec3<float>& n : normals()) {
    const double exact = OrenNayarDiffuse::value(seen_from_above<double>(n, angle), kSigma);
    const double error = std::abs(double(diffuse(seen_from_above<float>(n, angle))) - exact);
    if (!std::isfinite(error)) return error;
    largest = std::max(largest, error);
  }
  return largest;
}

/// The knot, each point seen from `angle` radians off its normal.
template <class Diffuse>
Image draw_from_above(double angle, int side, Diffuse diffuse) {
  const Scene scene = knot_scene(Material{});
  return shade_each(scene, side, [&](const Fragment& f) {
    const Vec3<float> n = normalize(constant_vec<float>(f.normal));
    return grey(double(diffuse(seen_from_above<float>(n, angle))));
  });
}

Region oren_nayar_above() {
  const auto naive = [](const Directions<float>& d) {
    return textbook::oren_nayar(d, float(kSigma));
  };
  const auto ours = [](const Directions<float>& d) {
    return OrenNayarDiffuse::value(d, float(kSigma));
  };
  Region region;
  region.name = "oren-nayar-from-above";
  region.group = "Models that divide";
  region.method = "Oren-Nayar by its angles, in float, the eye along the normal";
  region.reason =
      "n.v rounds above 1, of which there is no arc cosine; the eye's azimuth is that "
      "of a zero vector, 0 / 0";
  region.remedy = "sin a sin b cos phi = l.v - n.l n.v, without an angle, as ours";
  region.sweep = {"angle between n and v, radians", 1, 1e-9, true};
  region.measured = "largest difference from double over 40 normals, of full scale";
  region.limit = 0.01;
  region.error = [naive](double angle) { return oren_nayar_error(angle, naive); };
  region.guarded = [ours](double angle) { return oren_nayar_error(angle, ours); };
  region.sketch = [naive](double angle, int side) { return draw_from_above(angle, side, naive); };
  region.guarded_sketch = [ours](double angle, int side) {
    return draw_from_above(angle, side, ours);
  };
  return region;
}

/// l and v at an angle's cosine from n, on both sides of it, `v_cosine` on the eye's.
template <class S>
Directions<S> across_from(double l_cosine, double v_cosine) {
  const S lc = S(l_cosine), vc = S(v_cosine);
  const Vec3<S> l{-std::sqrt(1 - lc * lc), S(0), lc}, v{std::sqrt(1 - vc * vc), S(0), vc};
  return {{S(0), S(0), S(1)}, l, v, lc};
}

/// The highlight of a lamp at the eye, each pixel in float.
template <class Specular>
Image draw_microfacets(double roughness, int side, Specular specular) {
  Material m = formula("rgb-cook-torrance");
  const Scene scene = knot_scene(m);
  const Vec3d light = std::get<PointLight>(scene.view.lights.front()).position;
  return shade_each(scene, side, [&](const Fragment& f) {
    const Vec3<float> n = normalize(constant_vec<float>(f.normal));
    const Vec3<float> l = normalize(constant_vec<float>(light - f.position));
    const Vec3<float> v = normalize(constant_vec<float>(scene.view.camera.position - f.position));
    if (dot(n, l) < 0 || dot(n, v) < 0) return Vec3d{};
    return grey(double(specular(Directions<float>{n, l, v, dot(n, l)}, float(roughness))));
  });
}

Region cook_torrance_smooth() {
  const auto naive = [](const auto& d, auto roughness) {
    return textbook::cook_torrance(d, roughness);
  };
  const auto ours = [](const auto& d, auto roughness) {
    return CookTorranceHighlight::value(d, roughness, decltype(roughness)(1));
  };
  const auto error = [](auto highlight) {
    return [highlight](double roughness) {
      const auto d = across_from<double>(0.5, 0.5);
      const auto f = across_from<float>(0.5, 0.5);
      double largest = 0;
      for (int i = 0; i < 40; ++i) {  // within 5 %: a single one may be lucky
        const float near = float(roughness * (1 + i / 800.0));
        const double off = std::abs(double(highlight(f, near)) / highlight(d, double(near)) - 1);
        if (!std::isfinite(off)) return off;
        largest = std::max(largest, off);
      }
      return largest;
    };
  };
  Region region;
  region.name = "cook-torrance-smooth";
  region.group = "Models that divide";
  region.method = "Cook-Torrance with the printed GGX, in float, in the mirror direction";
  region.reason =
      "(n.h)^2 (alpha^2 - 1) + 1 cancels to alpha^2 = roughness^4, of which float keeps "
      "nothing below 6e-8: infinite";
  region.remedy = "alpha^2 (n.h)^2 + |n x h|^2 and alpha >= 1e-3, as ours";
  region.sweep = {"roughness", 1, 1e-3, true};
  region.measured = "error of the highlight's peak in float, share of it";
  region.limit = 0.02;
  region.error = error(naive);
  region.guarded = error(ours);
  region.sketch = [naive](double roughness, int side) {
    return draw_microfacets(roughness, side, naive);
  };
  region.guarded_sketch = [ours](double roughness, int side) {
    return draw_microfacets(roughness, side, ours);
  };
  region.shown_holds = 0.3;
  region.shown_fails = 0.02;
  return region;
}

/// The knot lit as it is, each point's n.v being `cosine`.
template <class Specular>
Image draw_grazing(double cosine, int side, Specular specular) {
  const Scene scene = knot_scene(Material{});
  const Vec3d light = std::get<PointLight>(scene.view.lights.front()).position;
  return shade_each(scene, side, [&](const Fragment& f) {
    const double l_cosine = dot(normalize(f.normal), normalize(light - f.position));
    if (l_cosine < 0) return Vec3d{};
    return grey(double(specular(across_from<float>(l_cosine, cosine), 0.3f)));
  });
}

Region cook_torrance_grazing() {
  const auto ours = [](const Directions<float>& d, float roughness) {
    return CookTorranceHighlight::value(d, roughness, 1.0f);
  };
  const auto fails = [](auto highlight) {
    return [highlight](double cosine) {
      double sum = 0;
      for (const double l_cosine : {cosine, 0.01, 0.5, 1.0}) {
        for (const double roughness : {0.05, 0.3, 1.0}) {
          sum += highlight(across_from<float>(l_cosine, cosine), float(roughness));
        }
      }
      return std::isfinite(sum) ? 0.0 : 1.0;
    };
  };
  Region region;
  region.name = "cook-torrance-grazing";
  region.group = "Models that divide";
  region.method = "Cook-Torrance as printed, D G F / (4 n.l n.v), in float, at grazing views";
  region.reason = "G and n.v both go to zero: 0 / 0 where the product n.l n.v underflows";
  region.remedy = "the visibility G / (4 n.l n.v) as one expression, n.v from 1e-3 on, as ours";
  region.sweep = {"n.v", 1, 1e-50, true};
  region.measured = "1 where some n.l and roughness give no number, else 0";
  region.limit = 0.5;
  region.error = fails(textbook::cook_torrance<float>);
  region.guarded = fails(ours);
  region.sketch = [](double cosine, int side) {
    return draw_grazing(cosine, side, textbook::cook_torrance<float>);
  };
  region.guarded_sketch = [ours](double cosine, int side) {
    return draw_grazing(cosine, side, ours);
  };
  return region;
}

}  // namespace

std::vector<Region> model_regions() {
  return {oren_nayar_above(), cook_torrance_smooth(), cook_torrance_grazing()};
}

}  // namespace lumaknot::stability
