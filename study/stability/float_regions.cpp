// Single precision.
#include <fmt/format.h>

#include <algorithm>

#include "math/angle.h"
#include "study/stability/regions.h"
#include "study/stability/test_scenes.h"

namespace lumaknot::stability {
namespace {

constexpr double kLevel = 1.0 / 255;  // one of 8 bits

/// Every length of the scene times the swept value, lit in float.
Region scaled(double to) {
  Region region;
  region.group = "Single precision";
  region.method = "the lighting in float";
  region.remedy = "scale the scene to lengths near 1, or light in double as the reference does";
  region.sweep = {"scale of all lengths", 1, to, true};
  region.measured = "largest difference of a channel from double, of full scale";
  region.limit = kLevel;
  region.error = [](double scale) {
    const Scene scene = knot_scene(Material{});
    return largest_difference(scene, 48, color_in<float>(scene, scale), color_in<double>(scene));
  };
  region.guarded = [](double scale) {
    const Scene scene = knot_scene(Material{});
    return largest_difference(scene, 48, color_in<double>(scene, scale), color_in<double>(scene));
  };
  region.sketch = [](double scale, int side) {
    const Scene scene = knot_scene(Material{});
    return shade_each(scene, side, color_in<float>(scene, scale));
  };
  region.guarded_sketch = [](double scale, int side) {
    const Scene scene = knot_scene(Material{});
    return shade_each(scene, side, color_in<double>(scene, scale));
  };
  return region;
}

Region huge_coordinates() {
  Region region = scaled(1e30);
  region.name = "huge-coordinates-float";
  region.reason =
      "the square of a length beyond 1.8e19 is infinite in float; the vector divided by it is zero";
  return region;
}

Region tiny_coordinates() {
  Region region = scaled(1e-30);
  region.name = "tiny-coordinates-float";
  region.reason =
      "the square of a length below 1e-19 loses its digits in float, and below 4e-23 "
      "is zero";
  return region;
}

/// The knot and its camera moved by `offset` in x, y and z; vertices in float or in
/// double.
Scene moved(double offset, bool in_float) {
  Scene scene = knot_scene(Material{});
  const Vec3d by{offset, offset, offset};
  for (Vec3d& p : scene.mesh.positions) {
    p = p + by;
    if (in_float) p = {float(p.x), float(p.y), float(p.z)};
  }
  scene.view.camera.position = scene.view.camera.position + by;
  scene.view.camera.target = scene.view.camera.target + by;
  PointLight& light = std::get<PointLight>(scene.view.lights.front());
  light.position = light.position + by;
  return scene;
}

Region far_from_origin() {
  Region region;
  region.name = "offset-float";
  region.group = "Single precision";
  region.method = "vertices in float, far from the origin";
  region.reason =
      "floats near 1e7 are a whole unit apart: vertices snap to a grid as coarse as the knot";
  region.remedy = "vertices relative to the object or the eye, the offset in double";
  region.sweep = {"offset in x, y and z", 1, 1e8, true};
  region.measured = "RMS difference from the picture without an offset, of full scale";
  region.limit = 0.02;
  const auto difference = [](double offset, bool in_float) {
    return rms_difference(draw(moved(offset, in_float), 96), draw(moved(0, false), 96));
  };
  region.error = [difference](double offset) { return difference(offset, true); };
  region.guarded = [difference](double offset) { return difference(offset, false); };
  region.sketch = [](double offset, int side) { return draw(moved(offset, true), side); };
  region.guarded_sketch = [](double offset, int side) { return draw(moved(offset, false), side); };
  region.shown_fails = 1e6;
  region.shown_holds = 1;
  return region;
}

constexpr double kInner = 12;  // degrees

Scene in_spot(double edge_degrees) {
  Scene scene = knot_scene(Material{});
  SpotLight spot;
  spot.direction = -spot.position;
  spot.inner_degrees = kInner;
  spot.outer_degrees = kInner + edge_degrees;
  scene.view.lights = {spot};
  return scene;
}

/// The light that arrives at `degrees` from the axis of the spot, in S.
template <class S>
double spot_light(const Scene& scene, double degrees) {
  const LightNumbers<S> light = lighting_of<S>(scene.view, Material{}).lights.front();
  const SpotLight& spot = std::get<SpotLight>(scene.view.lights.front());
  const Vec3d axis = normalize(spot.direction), across = normalize(cross(axis, Vec3d{0, 0, 1}));
  const double angle = degrees * kPi / 180;
  const Vec<S> to_light =
      constant_vec<S>((axis * std::cos(angle) + across * std::sin(angle)) * -5.0);
  return double(arriving<S>(light, to_light, unit(to_light)).x);
}

double spot_error(double edge_degrees) {
  constexpr int kAngles = 200;
  const Scene scene = in_spot(edge_degrees);
  double largest = 0;
  for (int i = 0; i <= kAngles; ++i) {
    const double degrees = kInner + edge_degrees * i / kAngles;
    largest = std::max(
        largest, std::abs(spot_light<float>(scene, degrees) - spot_light<double>(scene, degrees)));
  }
  return largest;
}

Region narrow_spot_edge() {
  Region region;
  region.name = "spot-edge-float";
  region.group = "Single precision";
  region.method = "a spot light with a narrow edge, in float";
  region.reason =
      "the edge is a ratio of differences of cosines that float knows to 6e-8; an edge less wide "
      "than that rounding is noise";
  region.remedy = "an edge of 0.1 degrees at least, which scene.json asks for";
  region.sweep = {"width of the edge, degrees", 10, 1e-5, true};
  region.measured = "largest difference of the light from double, of full scale";
  region.limit = kLevel;
  region.error = spot_error;
  region.guarded = [](double edge) { return spot_error(std::max(edge, 0.1)); };
  region.sketch = [](double edge, int side) {
    const Scene scene = in_spot(edge);
    return shade_each(scene, side, color_in<float>(scene));
  };
  region.guarded_sketch = [](double edge, int side) {
    return draw(in_spot(std::max(edge, 0.1)), side);
  };
  region.guarded_shows = [](double edge) { return fmt::format("{:.4g}", std::max(edge, 0.1)); };
  return region;
}

}  // namespace

std::vector<Region> float_regions() {
  return {huge_coordinates(), tiny_coordinates(), far_from_origin(), narrow_spot_edge()};
}

}  // namespace lumaknot::stability
