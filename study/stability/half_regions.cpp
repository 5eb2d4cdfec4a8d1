// Half precision, which hardware may use for `mediump`.
#include <algorithm>

#include "shaders/graph/half.h"
#include "study/stability/highlight_error.h"
#include "study/stability/regions.h"
#include "study/stability/test_scenes.h"

namespace lumaknot::stability {
namespace {

constexpr std::string_view kHighp = "highp (single precision) for what is named here";

/// A scene lit in half, compared with double.
Region in_half(const std::function<Scene(double)>& scene,
               const std::function<double(double)>& scale) {
  Region region;
  region.group = "Half precision";
  region.remedy = kHighp;
  region.measured = "largest difference of a channel from double, of full scale";
  region.error = [=](double x) {
    const Scene s = scene(x);
    return largest_difference(s, 48, color_in<Half>(s, scale(x)), color_in<double>(s, scale(x)));
  };
  region.guarded = [=](double x) {
    const Scene s = scene(x);
    return largest_difference(s, 48, color_in<float>(s, scale(x)), color_in<double>(s, scale(x)));
  };
  region.sketch = [=](double x, int side) {
    const Scene s = scene(x);
    return shade_each(s, side, color_in<Half>(s, scale(x)));
  };
  region.guarded_sketch = [=](double x, int side) {
    const Scene s = scene(x);
    return shade_each(s, side, color_in<float>(s, scale(x)));
  };
  return region;
}

double unscaled(double) { return 1; }

Region half_power() {
  Region region = in_half(
      [](double shininess) {
        Material m;
        m.parameters["shininess"] = shininess;
        m.diffuse = 0;
        Scene scene = knot_scene(m);
        scene.view.ambient = 0;
        return scene;
      },
      unscaled);
  region.name = "half-power";
  region.method = "Phong's highlight in half";
  region.reason =
      "r.v near 1 is known to 2^-11 at best, and the power k makes k times as much of it: the "
      "highlight gets bands";
  region.sweep = {"shininess k", 1, 1000, true};
  region.measured = "largest difference of the highlight from double, of its peak";
  region.limit = 0.05;
  region.error = peak_error<Half>;
  region.guarded = peak_error<float>;
  region.shown_holds = 10;
  region.shown_fails = 200;
  return region;
}

Region half_scaled(double to) {
  Region region =
      in_half([](double) { return knot_scene(Material{}); }, [](double scale) { return scale; });
  region.remedy = std::string(kHighp) + ", or vectors scaled to lengths near 1 before normalize";
  region.sweep = {"scale of all lengths (lamp and eye are some 5 away)", 1, to, true};
  region.limit = 0.25;
  return region;
}

constexpr std::string_view kScaleLimit =
    "; the picture in half is off by up to 0.1 at every scale, so the limit is above that";

Region half_far() {
  Region region = half_scaled(300);
  region.name = "half-normalize-far";
  region.method = "normalize of long vectors in half";
  region.reason = "a squared length of 65520 is infinite: vectors beyond 256 become zero";
  region.reason += kScaleLimit;
  return region;
}

Region half_near() {
  Region region = half_scaled(1e-4);
  region.error = [at = region.error](double scale) {
    double largest = 0;
    for (int i = 0; i < 6; ++i) {  // one scale may be lucky
      const double error = at(scale * std::pow(1.5, -i / 6.0));
      if (!std::isfinite(error)) return error;
      largest = std::max(largest, error);
    }
    return largest;
  };
  region.measured += ", over scales down to 2/3 of it";
  region.name = "half-normalize-near";
  region.method = "normalize of short vectors in half";
  region.reason =
      "a squared length below 2^-14 loses its digits and below 2^-25 is zero: vectors shorter than "
      "0.008 come out longer or shorter than one, or not at all";
  region.reason += kScaleLimit;
  return region;
}

/// The light that arrives from an inverse-square light of intensity 1 at a distance, in S.
template <class S>
double inverse_square(double distance) {
  LightNumbers<S> light;
  light.color = grey(S(1));
  light.constant = S(0);
  light.quadratic = S(1);
  return double(
      arriving<S>(light, make_vec(S(0), S(0), S(distance)), make_vec(S(0), S(0), S(1))).x);
}

template <class S>
double falloff_error(double distance) {
  return std::abs(inverse_square<S>(distance) * distance * distance - 1);
}

/// The knot lit as if each point's light had come `scale` times as far, its falloff in S, and the
/// loss undone: correct is the picture at scale 1.
template <class S>
Image draw_falloff(double scale, int side) {
  Scene scene = knot_scene(Material{});
  PointLight& light = std::get<PointLight>(scene.view.lights.front());
  return shade_each(scene, side, [&, color = color_in<double>(scene)](const Fragment& f) {
    const double far = length(light.position - f.position) * scale / 5;
    return color(f) * (inverse_square<S>(far) * far * far);
  });
}

Region half_falloff(double to) {
  Region region;
  region.group = "Half precision";
  region.method = "an inverse-square light in half";
  region.remedy = std::string(kHighp) + ", or distances in units of the light's reach";
  region.sweep = {"distance to the light", 1, to, true};
  region.measured = "error of 1 / d^2, share of it";
  region.limit = 0.02;
  region.error = falloff_error<Half>;
  region.guarded = falloff_error<float>;
  region.sketch = draw_falloff<Half>;
  region.guarded_sketch = draw_falloff<float>;
  return region;
}

Region half_falloff_far() {
  Region region = half_falloff(300);
  region.name = "half-falloff-far";
  region.reason =
      "d^2 is infinite from d = 256 on, and the light is out; 1 / d^2 loses digits "
      "before";
  return region;
}

Region half_falloff_near() {
  Region region = half_falloff(2e-3);
  region.name = "half-falloff-near";
  region.reason =
      "d^2 loses its digits below 2^-14 and 1 / d^2 is infinite below d = 0.004; times a zero "
      "cosine "
      "it is no number";
  return region;
}

Region half_dark(std::string_view name, std::string_view space, std::string_view reason) {
  Region region = in_half(
      [material = formula(std::string(space) + "-phong")](double level) {
        Scene scene = knot_scene(material);
        scene.texture = Vec3d{level, level / 2, level / 4};
        return scene;
      },
      unscaled);
  region.name = name;
  region.method = std::string(space) + " lighting of dark colours in half";
  region.reason = reason;
  region.sweep = {"texture's red, twice its green and four times its blue", 0.5, 1e-5, true};
  region.limit = 0.1;
  return region;
}

/// The change of the RGB cube's corners by n passes of M and W in half.
double half_passes(double passes) {
  double largest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d rgb{double(corner & 1), double(corner >> 1 & 1), double(corner >> 2)};
    Vec<Half> color = constant_vec<Half>(rgb);
    for (int i = 0; i < int(passes); ++i) color = rgb_from_yiq(yiq_from_rgb<Half>(color));
    const Vec3d d = Vec3d{double(color.x), double(color.y), double(color.z)} - rgb;
    largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  return largest;
}

Region half_round_trip() {
  Region region;
  region.name = "half-yiq-round-trip";
  region.group = "Half precision";
  region.method = "YIQ and back in half, pass after pass";
  region.reason = "each pass rounds M and W, six products and four sums to 2^-11";
  region.remedy = "the collapsed form F = T + (Y_F - Y_T), which goes through no matrix; or highp";
  region.sweep = {"passes", 1, 100, false, true};
  region.measured = "largest difference of a channel from what went in, of full scale";
  region.limit = 1.0 / 255;
  region.error = half_passes;
  region.sketch = [](double passes, int side) {
    const Scene scene = knot_scene(Material{});
    return shade_each(scene, side, [&](const Fragment& f) {
      Vec<Half> color = constant_vec<Half>(texture_color(scene.texture, f.uv));
      for (int i = 0; i < int(passes); ++i) color = rgb_from_yiq(yiq_from_rgb<Half>(color));
      return Vec3d{double(color.x), double(color.y), double(color.z)};
    });
  };
  return region;
}

}  // namespace

std::vector<Region> half_regions() {
  return {half_power(),
          half_far(),
          half_near(),
          half_falloff_far(),
          half_falloff_near(),
          half_dark("half-cieluv-dark", "cieluv",
                    "the guard of its division by X + 15 Y + 3 Z, 1e-9, is zero in half, and so is "
                    "the XYZ of a dark colour: 0 / 0"),
          half_round_trip()};
}

}  // namespace lumaknot::stability
