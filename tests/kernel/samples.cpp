#include "tests/kernel/samples.h"

#include "math/angle.h"
#include "tests/shaders/formulas/random_surface.h"

namespace lumaknot::testing {
namespace {

double radians(double degrees) { return degrees * kPi / 180; }

/// One of the given numbers in one row of sixteen each, else one up to `most`.
double number_with(RandomSurface& random, std::initializer_list<double> special, double min,
                   double max) {
  const std::size_t kind = random.index(16);
  const double plain = random.number(min, max);
  return kind < special.size() ? special.begin()[kind] : plain;
}

/// Components up to `most`, many of them at the ends.
Vec3d color(RandomSurface& random, double max) {
  const double x = number_with(random, {0, max}, 0, max);
  const double y = number_with(random, {0, max}, 0, max);
  return {x, y, number_with(random, {0, max}, 0, max)};
}

/// `v` or its opposite, three times in four on the side of `n`.
Vec3d mostly_along(RandomSurface& random, const Vec3d& v, const Vec3d& n) {
  const bool is_along = dot(v, n) > 0, along = random.index(4) > 0;
  return is_along == along ? v : -v;
}

Falloff falloff(RandomSurface& random) {
  const std::size_t kind = random.index(4);
  const double c = random.number(0.1, 2), l = random.number(0, 1), q = random.number(0, 1);
  if (kind == 0) return {1, 0, 0};
  if (kind == 1) return {0, l + 0.1, 0};
  return kind == 2 ? Falloff{0, 0, q + 0.1} : Falloff{c, l, q};
}

/// Cones from a tenth of a degree, the narrowest that scenes allow, to all round.
void add_cone(RandomSurface& random, LightSample& light) {
  constexpr double kMinEdge = 0.1;  // degrees
  const std::size_t kind = random.index(16);
  const double widest = kind == 0 ? 1 : kind == 1 ? 180 : 60;
  const double outer = random.number(kMinEdge, widest);
  const double inner = number_with(random, {0, outer - kMinEdge}, 0, outer - kMinEdge);
  light.cos_outer = std::cos(radians(outer));
  light.cone_scale = 1 / (std::cos(radians(inner)) - light.cos_outer);
  const Vec3d off = random.direction() * std::tan(radians(std::min(outer, 60.0)));
  light.aim = normalize(-light.to_light + off * random.number(0, 1.2));
}

LightSample light(RandomSurface& random, const Vec3d& position, const Vec3d& normal) {
  LightSample result;
  result.to_light = mostly_along(random, random.direction(), normal);
  result.position = position + result.to_light * random.number(0.5, 6);
  result.color = color(random, 1) * random.number(0.25, 2);
  result.falloff = falloff(random);
  add_cone(random, result);
  return result;
}

/// Where the light's mirror image would be seen, for every second row: random eyes miss highlights.
Vec3d to_eye(RandomSurface& random, const Vec3d& normal, const Vec3d& to_light) {
  const Vec3d anywhere = mostly_along(random, random.direction(), normal);
  const Vec3d mirror = normal * (2 * dot(normal, to_light)) - to_light;
  return random.index(2) ? anywhere : normalize(mirror + anywhere * random.number(0, 0.4));
}

/// Moves the light; a spot still shines at the surface.
void place_light(Sample& s, const Vec3d& position) {
  for (LightSample& light : s.lights) {
    light.position = position;
    light.to_light = unit(position - s.position);
    if (light.to_light != Vec3d{}) light.aim = -light.to_light;
  }
}

constexpr std::size_t kEdges = 14;

/// `s` at one of the edge cases that formulas must handle.
Sample at_edge(Sample s, std::size_t edge) {
  const Vec3d up{0, 0, 1};
  const double x = s.texture.x + 0.25, y = s.texture.y + 0.25, z = s.texture.z + 0.25;
  const auto at_origin = [&](const Vec3d& eye, const Vec3d& lamp) {
    s.position = {};
    s.normal = up;
    s.eye = eye;
    place_light(s, lamp);
  };
  switch (edge) {
    case 0:
      s.eye = s.position;
      break;
    case 1:
      place_light(s, s.position);
      break;
    case 2:
      s.eye = s.position;
      place_light(s, s.position);
      break;
    case 3:
      s.normal = {};
      break;
    case 4:
      s.normal = s.normal * 1e-3;
      break;
    case 5:
      place_light(s, s.eye);
      break;
    case 6:
      at_origin({x, y, z}, {-x, -y, -z});
      break;  // l = -v, light behind
    case 7:
      at_origin({-x, -y, -z}, {x, y, z});
      break;  // l = -v, eye behind
    case 8:
      at_origin({-x, -y, z}, {x, y, z});
      break;  // the mirror image
    case 9:
      at_origin({x, -y, z}, {y, x, 0});
      break;  // the light grazes
    case 10:
      at_origin({x, y, 0}, {-y, x, z});
      break;  // the eye grazes
    case 11:
      at_origin({0, 0, x}, {0, 0, y});
      break;  // all along the normal
    case 12:
      at_origin({x * 1e-3, 0, 1e-3}, {0, y * 1e-3, 1e-3});
      break;  // near
    default:
      at_origin({x * 500, 0, 500}, {0, y * 500, 500});
      break;  // far
  }
  return s;
}

Sample sample(RandomSurface& random, std::size_t row) {
  Sample s;
  s.position = random.vector(-1, 1);
  const Vec3d n = random.direction();
  s.normal = n * number_with(random, {1, 1, 1, 1}, 0.9, 1);
  for (LightSample& l : s.lights) l = light(random, s.position, n);
  s.eye = s.position + to_eye(random, n, s.lights[0].to_light) * random.number(0.5, 6);
  s.texture = color(random, 1);
  s.ambient = color(random, 1);
  s.diffuse = color(random, 1.5);
  s.specular = color(random, 1.5);
  s.emissive = color(random, 0.5);
  s.shininess = number_with(random, {0, 1, 2, 1000}, 0, 200);
  s.roughness = number_with(random, {0, 1}, 0, 1);
  s.reflectance = number_with(random, {0, 1, 0.04, 0.04}, 0, 1);
  s.darkness = number_with(random, {0, 1, 2, 10}, 0, 3);
  s.luma_offset = number_with(random, {-0.1, 0}, -0.3, 0.3);
  const bool is_edge = row % 4 == 0 && row < kKernelRows / 2;
  return is_edge ? at_edge(s, row / 4 % kEdges) : s;
}

}  // namespace

const std::vector<Sample>& kernel_samples() {
  static const std::vector<Sample> kSamples = [] {
    RandomSurface random;
    std::vector<Sample> list;
    for (std::size_t row = 0; row < kKernelRows; ++row) list.push_back(sample(random, row));
    return list;
  }();
  return kSamples;
}

}  // namespace lumaknot::testing
