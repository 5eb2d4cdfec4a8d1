// Highlights.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "math/angle.h"
#include "study/stability/highlight_error.h"
#include "study/stability/regions.h"
#include "study/stability/test_scenes.h"
#include "study/stability/textbook.h"

namespace lumaknot::stability {
namespace {

/// The knot with only its highlight.
Scene highlight_scene(Model model, double shininess) {
  Material m;
  m.model = model;
  m.parameters["shininess"] = shininess;
  m.diffuse = 0;
  Scene scene = knot_scene(m);
  scene.view.ambient = 0;
  return scene;
}

Vec3d at_angle(double degrees) {
  return {std::sin(degrees * kDegree), 0, std::cos(degrees * kDegree)};
}

/// The highlight on +z of a light 60 degrees to one side, seen `degrees` beyond Phong's cut-off,
/// which is 30 degrees to the same side.
double highlight_beyond(Model model, double shininess, double degrees) {
  const Vec3d n{0, 0, 1}, l = at_angle(-60), v = at_angle(-30 - degrees);
  return specular_term<double>(model, {n, l, v, dot(n, l)},
                               ModelParameters<double>().with("shininess", shininess));
}

constexpr double kDifferenceStep = 0.5;  // degrees

/// By how much the highlight's second difference over kDifferenceStep changes at Phong's cut-off:
/// before it, on it and beyond. Of the k-th power of a sine about h^(k-2) (2^k - 2), where h is the
/// step, and so not the jump of the second derivative, to which it comes down with h alone.
double change_of_second_difference(Model model, double shininess) {
  const auto f = [&](int steps) {
    return highlight_beyond(model, shininess, kDifferenceStep * steps);
  };
  const auto [min, max] =
      std::minmax({f(-2) - 2 * f(-1) + f(0), f(-1) - 2 * f(0) + f(1), f(0) - 2 * f(1) + f(2)});
  return (max - min) / std::pow(kDifferenceStep * kDegree, 2);
}

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// What the slope of max(sin x, 0)^k jumps by at 0: of k x^(k-1), the limit.
double slope_jump(double k) { return k > 1 ? 0 : k == 1 ? 1 : kUnbounded; }

/// The same of its second derivative, of k (k - 1) x^(k-2).
double curvature_jump(double k) { return k > 2 || k == 1 ? 0 : k == 2 ? 2 : kUnbounded; }

Region phong_cutoff() {
  Region region;
  region.name = "phong-cutoff";
  region.group = "Highlights";
  region.method = "Phong's highlight at low shininess";
  region.reason =
      "max(r.v, 0)^k ends at 90 degrees with a step of its slope at k = 1, of its curvature at k = "
      "2: eyes see both as an edge. For k a little above 2 nothing jumps, but the curvature still "
      "comes in within the half degree that is measured";
  region.remedy = "Blinn-Phong, whose n.h is still 0.7 there; or k >= 3";
  region.sweep = {"shininess k", 32, 0.5, true};
  region.measured =
      "change of the second difference over steps of half a degree at the cut-off, 1 / radian^2";
  region.limit = 0.5;
  region.error = [](double k) { return change_of_second_difference(Model::kPhong, k); };
  region.guarded = [](double k) { return change_of_second_difference(Model::kBlinnPhong, k); };
  region.also = {{"exact jump of the slope, 1 / radian", slope_jump},
                 {"exact jump of the second derivative, 1 / radian^2", curvature_jump}};
  region.sketch = [](double k, int side) { return draw(highlight_scene(Model::kPhong, k), side); };
  region.guarded_sketch = [](double k, int side) {
    return draw(highlight_scene(Model::kBlinnPhong, k), side);
  };
  region.shown_holds = 3;
  region.shown_fails = 1;
  return region;
}

/// Only the highlight of a light `degrees` about the axis from the eye.
Scene lit_from(double degrees, Highlights highlights) {
  Scene scene = highlight_scene(Model::kPhong, 5);
  scene.view.material.highlights = highlights;
  const double a = degrees * kDegree;
  scene.view.lights = {PointLight{
      .position = {3.6 * std::sin(a), -3.6 * std::cos(a), 2.4}, .color = {}, .falloff = {}}};
  return scene;
}

/// Whether the surface faces away from the light.
bool is_behind(const Scene& scene, const Fragment& f) {
  return dot(f.normal, std::get<PointLight>(scene.view.lights.front()).position - f.position) <= 0;
}

double lit_behind(const Scene& scene) {
  return share_of(scene, 96, [&, color = color_in<double>(scene)](const Fragment& f) {
    return is_behind(scene, f) && color(f).x > 1.0 / 255;
  });
}

Image draw_behind(const Scene& scene, int side) {
  return shade_each(scene, side, [&, color = color_in<double>(scene)](const Fragment& f) {
    const Vec3d c = color(f);
    return is_behind(scene, f) ? Vec3d{c.x, 0, 0} : c;
  });
}

Region highlight_behind() {
  Region region;
  region.name = "highlight-behind";
  region.group = "Highlights";
  region.method = "Phong's highlight without a gate, as Table 1 has it";
  region.reason =
      "nothing in max(r.v, 0)^k asks whether the light is in front of the surface: below n.l = 0 "
      "the "
      "mirror direction still meets the eye at grazing angles";
  region.remedy = "no highlight where n.l <= 0 (material.highlights \"gated\")";
  region.sweep = {"angle from the eye to the light about the axis, degrees", 0, 170};
  region.measured = "share of pixels with a highlight where n.l <= 0 (red)";
  region.limit = 0.01;
  region.error = [](double a) { return lit_behind(lit_from(a, Highlights::kFree)); };
  region.guarded = [](double a) { return lit_behind(lit_from(a, Highlights::kGated)); };
  region.sketch = [](double a, int side) {
    return draw_behind(lit_from(a, Highlights::kFree), side);
  };
  region.guarded_sketch = [](double a, int side) {
    return draw_behind(lit_from(a, Highlights::kGated), side);
  };
  region.shown_fails = 160;
  return region;
}

double washed(const Scene& scene) {
  return share_of(
      scene, 96, [color = color_in<double>(scene)](const Fragment& f) { return color(f).x > 0.5; });
}

Region shininess_zero() {
  Region region;
  region.name = "shininess-zero";
  region.group = "Highlights";
  region.method = "Phong's highlight as the shininess goes to 0";
  region.reason =
      "x^0 is 1 for every x, 0 too: the highlight covers the surface, its dark side "
      "with it";
  region.remedy =
      "Cook-Torrance, whose highlight gets weaker as it gets wider; or shininess >= 1 "
      "and a gate";
  region.sweep = {"shininess k", 32, 0};
  region.measured = "share of pixels with a highlight above 1/2";
  region.limit = 0.5;
  region.error = [](double k) { return washed(highlight_scene(Model::kPhong, k)); };
  const auto cook_torrance = [](double k) {  // as wide: alpha^2 = 2 / (k + 2)
    Scene scene = highlight_scene(Model::kCookTorrance, k);
    scene.view.material.parameters["roughness"] = std::pow(2 / (k + 2), 0.25);
    return scene;
  };
  region.guarded = [=](double k) { return washed(cook_torrance(k)); };
  region.sketch = [](double k, int side) { return draw(highlight_scene(Model::kPhong, k), side); };
  region.guarded_sketch = [=](double k, int side) { return draw(cook_torrance(k), side); };
  region.guarded_shows = [=](double k) {
    return fmt::format("roughness {:.3g}", cook_torrance(k).view.material.parameters["roughness"]);
  };
  return region;
}

/// Only the highlight, its power computed in float by `power`.
template <class Power>
FragmentColor highlight_by(const Scene& scene, double shininess, Power power) {
  const Vec3d light = std::get<PointLight>(scene.view.lights.front()).position;
  return [light, eye = scene.view.camera.position, shininess, power](const Fragment& f) {
    const Vec3d n = unit(f.normal), l = unit(light - f.position), v = unit(eye - f.position);
    const double cosine = std::max(dot(unit(n * (2 * dot(n, l)) - l), v), 0.0);
    const double highlight = power(float(cosine), float(shininess));
    return grey(highlight);
  };
}

Region power_zero_zero() {
  const auto ours = [](float b, float k) { return power(b, k); };
  Region region;
  region.name = "power-zero-zero";
  region.group = "Highlights";
  region.method = "pow(b, k) as 2^(k log2 b) in float, as graphics hardware has it";
  region.reason =
      "log2 of 0 is minus infinity, and times k = 0 no number; GLSL leaves pow(0, 0) "
      "undefined";
  region.remedy = "0^0 = 1 as a case of its own: safe_power in what we emit";
  region.sweep = {"shininess k", 1, 1e-50, true};
  region.measured = "1 where some r.v in [0, 1] gives no number, else 0";
  region.limit = 0.5;
  const auto fails = [](auto power) {
    return [power](double k) {
      return std::isfinite(power(0.0f, float(k)) + power(0.5f, float(k)) + power(1.0f, float(k)))
                 ? 0.0
                 : 1.0;
    };
  };
  region.error = fails(textbook::power<float>);
  region.guarded = fails(ours);
  region.sketch = [](double k, int side) {
    const Scene scene = highlight_scene(Model::kPhong, 1);
    return shade_each(scene, side, highlight_by(scene, k, textbook::power<float>));
  };
  region.guarded_sketch = [ours](double k, int side) {
    const Scene scene = highlight_scene(Model::kPhong, 1);
    return shade_each(scene, side, highlight_by(scene, k, ours));
  };
  return region;
}

Region shininess_float() {
  Region region;
  region.name = "shininess-float";
  region.group = "Highlights";
  region.method = "Phong's highlight in float at high shininess";
  region.reason = "r.v is known to 6e-8, and its k-th power to k times that";
  region.remedy = "1 - (r.v)^2 as |r x v|^2, as our Cook-Torrance takes it; or double";
  region.sweep = {"shininess k", 1, 1e6, true};
  region.measured = "largest difference of the highlight from double, of its peak";
  region.limit = 1.0 / 255;
  region.error = peak_error<float>;
  region.sketch = peak_sketch<float>;
  region.guarded_sketch = peak_sketch<double>;
  const auto close_up = [](double k) {
    return fmt::format("{:.4g}, to {:.2g} degrees about the mirror direction", k,
                       std::sqrt(2 * std::log(100) / k) * kDegrees);
  };
  region.guarded_shows = close_up;
  region.shown_holds = 10;
  region.shown_fails = 4e4;
  return region;
}

/// The mean highlight of the picture at n x n samples per pixel.
double mean_highlight(double shininess, int samples) {
  constexpr int kSide = 64;
  Scene scene = highlight_scene(Model::kPhong, shininess);
  scene.view.image.samples = samples;
  double sum = 0;
  for (const RgbaPixel& pixel : draw(scene, kSide).pixels) sum += pixel.color.r;
  return sum / (kSide * kSide);
}

Region shininess_sampling() {
  Region region;
  region.name = "shininess-sampling";
  region.group = "Highlights";
  region.method = "one sample per pixel of a small highlight";
  region.reason =
      "a highlight some sqrt(2 / k) radians wide falls between the samples: it "
      "flickers as things move";
  region.remedy =
      "more samples per pixel (image.samples), or a lower shininess where a pixel spans "
      "much of the surface";
  region.sweep = {"shininess k", 1, 1e6, true};
  region.measured = "error of the picture's mean highlight, 1 sample against 8 x 8, share of it";
  region.limit = 0.1;
  region.error = [](double k) { return std::abs(mean_highlight(k, 1) / mean_highlight(k, 8) - 1); };
  region.sketch = [](double k, int side) { return draw(highlight_scene(Model::kPhong, k), side); };
  region.guarded_sketch = [](double k, int side) {
    Scene scene = highlight_scene(Model::kPhong, k);
    scene.view.image.samples = 8;
    return draw(scene, side);
  };
  region.guarded_shows = [](double k) { return fmt::format("{}, 8 x 8 samples", k); };
  region.shown_fails = 3000;
  region.shown_holds = 10;
  return region;
}

}  // namespace

std::vector<Region> highlight_regions() {
  return {phong_cutoff(),    highlight_behind(), shininess_zero(),
          power_zero_zero(), shininess_float(),  shininess_sampling()};
}

}  // namespace lumaknot::stability
