// The positions of lights and eyes.
#include <algorithm>

#include "math/angle.h"
#include "meshgen/spine.h"
#include "render/fast/renderer.h"
#include "study/stability/regions.h"
#include "study/stability/test_scenes.h"
#include "study/stability/textbook.h"

namespace lumaknot::stability {
namespace {

template <class Unit>
FragmentColor lambert_by(const Scene& scene, double scale, Unit unit_of) {
  const Vec3d light = std::get<PointLight>(scene.view.lights.front()).position;
  return [light, scale, unit_of](const Fragment& f) {
    const Vec3<float> l = unit_of(constant_vec<float>((light - f.position) * (scale / 5)));
    const double lit = dot(constant_vec<float>(f.normal), l);
    return grey(lit > 0 || !std::isfinite(lit) ? lit : 0.0);
  };
}

Region light_on_surface() {
  const auto naive = [](const Vec3<float>& v) { return normalize(v); };
  const auto ours = [](const Vec3<float>& v) { return unit(v); };
  const auto fails = [](auto unit_of) {
    return [unit_of](double distance) {
      const Vec3<float> l = unit_of(constant_vec<float>(Vec3d{0.48, -0.6, 0.64} * distance));
      return is_finite(Vec3d{l.x, l.y, l.z}) ? 0.0 : 1.0;
    };
  };
  const auto picture = [](auto unit_of) {
    return [unit_of](double distance, int side) {
      const Scene scene = knot_scene(Material{});
      return shade_each(scene, side, lambert_by(scene, distance, unit_of));
    };
  };
  Region region;
  region.name = "light-on-surface";
  region.group = "Lights and eyes";
  region.method = "v / |v| of the vector to a light (or an eye) on the surface, in float";
  region.reason = "its square is 0 in float below 3e-23, and 0 / 0 no number";
  region.remedy = "the unit vector of zero is zero: safe_normalize in what we emit";
  region.sweep = {"distance", 1, 1e-30, true};
  region.measured = "1 where the direction is no number, else 0";
  region.limit = 0.5;
  region.error = fails(naive);
  region.guarded = fails(ours);
  region.sketch = picture(naive);
  region.guarded_sketch = picture(ours);
  return region;
}

/// A lamp near the nearest bend of the knot.
Scene near_lamp(double distance, const Falloff& falloff) {
  Scene scene = knot_scene(Material{});
  scene.view.lights = {
      PointLight{.position = {0, -1.4 - distance, 0.4}, .color = {}, .falloff = falloff}};
  return scene;
}

double burnt(const Scene& scene) {
  return share_of(scene, 96, [color = color_in<double>(scene)](const Fragment& f) {
    const Vec3d c = color(f);
    return largest_component(c) > 1;
  });
}

Region light_near_surface() {
  constexpr Falloff kInverse{0, 0, 1}, kBounded{1, 0, 1};
  Region region;
  region.name = "light-near-surface";
  region.group = "Lights and eyes";
  region.method = "falloff 1 / d^2";
  region.reason =
      "it has no bound: within a unit of length the surface gets more than it is sent "
      "elsewhere, and what it answers is clipped";
  region.remedy = "1 / (1 + d^2)";
  region.sweep = {"distance of the lamp from the tube", 3, 0.1, true};
  region.measured = "share of pixels above 1";
  region.limit = 0.05;
  region.error = [=](double d) { return burnt(near_lamp(d, kInverse)); };
  region.guarded = [=](double d) { return burnt(near_lamp(d, kBounded)); };
  region.sketch = [=](double d, int side) { return draw(near_lamp(d, kInverse), side); };
  region.guarded_sketch = [=](double d, int side) { return draw(near_lamp(d, kBounded), side); };
  return region;
}

constexpr double kDarkness = 0.25;

/// The light at the eye: n.l = n.v = `cosine`.
Directions<float> seen_at(double cosine) {
  const float c = float(cosine), s = std::sqrt(1 - c * c);
  return {{0, 0, 1}, {s, 0, c}, {s, 0, c}, c};
}

/// The knot in the light of a lamp at the eye, its diffuse term by `diffuse`, drawn where n.v is
/// above `cosine`.
template <class Diffuse>
Image draw_head_lamp(double cosine, int side, Diffuse diffuse) {
  const Scene scene = knot_scene(Material{});
  return shade_each(scene, side, [&](const Fragment& f) {
    const Vec3d v = unit(scene.view.camera.position - f.position), n = unit(f.normal);
    const Vec3<float> to_eye = constant_vec<float>(v), normal = constant_vec<float>(n);
    const double seen = std::max(dot(n, v), 0.0);
    if (seen < cosine) return Vec3d{};
    constexpr double kExposure = 0.2;
    return grey(kExposure *
                double(diffuse(Directions<float>{normal, to_eye, to_eye, float(seen)})));
  });
}

Region light_at_eye() {
  const auto naive = [](const Directions<float>& d) {
    return textbook::minnaert(d, float(kDarkness));
  };
  const auto ours = [](const Directions<float>& d) {
    return MinnaertDiffuse::value(d, float(kDarkness));
  };
  Region region;
  region.name = "light-at-eye";
  region.group = "Lights and eyes";
  region.method = "Minnaert's term, k = 1/4, with the light at the eye";
  region.reason =
      "n.l = n.v makes it (n.l)^(2k - 1), which for k < 1/2 grows without bound towards the limb "
      "and "
      "is no number on it";
  region.remedy = "(n.l n.v) not below 1e-4, as ours: at most 10 here";
  region.sweep = {"n.l = n.v", 1, 1e-50, true};
  region.measured = "diffuse term";
  region.limit = 10.5;
  region.error = [naive](double c) { return double(naive(seen_at(c))); };
  region.guarded = [ours](double c) { return double(ours(seen_at(c))); };
  region.sketch = [naive](double c, int side) { return draw_head_lamp(c, side, naive); };
  region.guarded_sketch = [ours](double c, int side) { return draw_head_lamp(c, side, ours); };
  region.shown_holds = 0.5;
  region.shown_fails = 1e-50;
  return region;
}

const Vec3d kToLamp = normalize(Vec3d{-1.5, -3, 3.5});

Scene far_lamp(double distance) {
  Scene scene = knot_scene(Material{});
  scene.view.lights = {PointLight{.position = kToLamp * distance, .color = {}, .falloff = {}}};
  return scene;
}

Scene sun(double) {
  Scene scene = knot_scene(Material{});
  scene.view.lights = {DirectionalLight{-kToLamp, {}}};
  return scene;
}

Region light_at_infinity() {
  Region region;
  region.name = "light-at-infinity";
  region.group = "Lights and eyes";
  region.method = "a point light far away, in float";
  region.reason = "the square of a distance beyond 1.8e19 is infinite, and the direction zero";
  region.remedy = "a directional light";
  region.sweep = {"distance", 10, 1e30, true};
  region.measured = "largest difference of a channel from double, of full scale";
  region.limit = 1.0 / 255;
  region.error = [](double d) {
    const Scene scene = far_lamp(d);
    return largest_difference(scene, 48, color_in<float>(scene), color_in<double>(scene));
  };
  region.guarded = [](double d) {
    const Scene scene = sun(d);
    return largest_difference(scene, 48, color_in<float>(scene), color_in<double>(scene));
  };
  region.sketch = [](double d, int side) {
    const Scene scene = far_lamp(d);
    return shade_each(scene, side, color_in<float>(scene));
  };
  region.guarded_sketch = [](double d, int side) {
    const Scene scene = sun(d);
    return shade_each(scene, side, color_in<float>(scene));
  };
  region.guarded_shows = [](double) { return "directional"; };
  return region;
}

/// The unit vector of l + v in S, where l is `angle` from opposite to v towards `across`.
template <class S>
Vec3d half_way(const Vec3d& v, const Vec3d& across, double angle) {
  const Vec3d l = across * std::sin(angle) - v * std::cos(angle);
  const Vec3<S> h = normalize(constant_vec<S>(l) + constant_vec<S>(v));
  return {double(h.x), double(h.y), double(h.z)};
}

/// How far h = l + v in S is from what it is in double, in degrees: l nearly opposite to v, in
/// several directions around it.
template <class S>
double half_way_error(double angle) {
  constexpr int kWays = 24;
  double largest = 0;
  for (int i = 0; i < kWays; ++i) {
    const double a = kTurn * i / kWays;
    const Vec3d v = normalize(Vec3d{std::cos(a), std::sin(a), 0.5});
    const Vec3d across = normalize(cross(v, Vec3d{0, 1, 0.3}));
    const Vec3d exact = across * std::cos(angle / 2) + v * std::sin(angle / 2);
    const Vec3d found = half_way<S>(v, across, angle);
    if (!is_finite(found)) return std::numeric_limits<double>::quiet_NaN();
    largest = std::max(largest, std::acos(std::clamp(dot(found, exact), -1.0, 1.0)) * kDegrees);
  }
  return largest;
}

/// The knot with Blinn's highlight, each point lit from `angle` off the line from the eye.
template <class S>
Image draw_lit_from_behind(double angle, int side) {
  const Scene scene = knot_scene(Material{});
  return shade_each(scene, side, [&](const Fragment& f) {
    const Vec3d v = normalize(scene.view.camera.position - f.position);
    const Vec3d across = normalize(cross(v, Vec3d{0, 1, 0.3}));
    const double cosine = dot(normalize(f.normal), half_way<S>(v, across, angle));
    return grey(cosine > 0 ? std::pow(cosine, 8) : cosine * 0);  // NaN stays NaN
  });
}

Region half_way_opposite() {
  Region region;
  region.name = "half-way-opposite";
  region.group = "Lights and eyes";
  region.method = "Blinn's half-way vector in float, the light opposite to the eye";
  region.reason =
      "l + v cancels: what is left of unit vectors is 6e-8 of noise, and where they "
      "are opposite 0 / 0";
  region.remedy =
      "gate highlights where n.l <= 0 or n.v <= 0: one of them holds there; the unit "
      "vector of zero is zero";
  region.sweep = {"angle between l and -v, radians", 1, 1e-9, true};
  region.measured = "error of the half-way direction, degrees";
  region.limit = 5;
  region.error = half_way_error<float>;
  region.guarded = half_way_error<double>;
  region.sketch = draw_lit_from_behind<float>;
  region.guarded_sketch = draw_lit_from_behind<double>;
  return region;
}

/// An eye `distance` away from the knot's centre line, looking along it.
Scene eye_near_line(double distance) {
  Scene scene = knot_scene(Material{});
  const Spine spine(components(sketch_knot()).front());
  const RingFrame frame = spine.frame(0.3);
  const Vec3d eye = frame.position + normalize(frame.position) * distance;
  scene.view.camera = {.position = eye,
                       .target = eye + frame.tangent - normalize(frame.position) * distance * 0.5,
                       .up = {0, 0, 1},
                       .fov_degrees = 70};
  return scene;
}

Region eye_inside_tube() {
  Region region;
  region.name = "eye-inside-tube";
  region.group = "Lights and eyes";
  region.method = "both sides of triangles drawn, the eye near or in the tube of radius 0.18";
  region.reason =
      "from inside one sees walls whose normals point away: lit by what is outside, "
      "with highlights through the wall";
  region.remedy =
      "draw front faces alone (`lumaknot render --fast --cull`), or turn normals to the eye";
  region.sweep = {"distance of the eye from the centre line", 0.6, 0.0};
  region.measured = "share of pixels with n.v < 0";
  region.limit = 0.02;
  region.error = [](double d) {
    const Scene scene = eye_near_line(d);
    return share_of(scene, 96, [&](const Fragment& f) {
      return dot(f.normal, scene.view.camera.position - f.position) < 0;
    });
  };
  region.sketch = [](double d, int side) { return draw(eye_near_line(d), side); };
  region.guarded_sketch = [](double d, int side) {
    Scene scene = eye_near_line(d);
    scene.view.image = {side, side, 1};
    Image image;
    fast::Renderer(scene, {.cull_back_faces = true}).draw(image);
    return image;
  };
  region.shown_holds = 0.5;
  region.shown_fails = 0.05;
  return region;
}

}  // namespace

std::vector<Region> light_regions() {
  return {light_on_surface(),  light_near_surface(), light_at_eye(),
          light_at_infinity(), half_way_opposite(),  eye_inside_tube()};
}

}  // namespace lumaknot::stability
