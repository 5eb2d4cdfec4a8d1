/// Shared by the tests of the lighting models: terms of one white light, given by directions.
#pragma once

#include <cmath>

#include "math/angle.h"
#include "shaders/formulas/lighting.h"

namespace lumaknot {

/// The unit vector `theta` degrees away from +z, at the azimuth `phi`.
inline Vec3d at_angles(double theta, double phi = 0) {
  const double t = theta * kDegree, p = phi * kDegree;
  return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

/// Grey terms, as one number each.
struct GreyTerms {
  double diffuse, specular;
};

/// The terms of the lights of `view` on a point of `material`.
inline Terms<double> terms_of(const View& view, const SurfacePoint<double>& point,
                              const Material& material) {
  const auto lighting = lighting_of<double>(view, material);
  return surface_terms(point, lighting.eye_position, lighting.lights, lighting.parameters,
                       material);
}

inline GreyTerms grey_terms(const View& view, const SurfacePoint<double>& point,
                            const Material& material) {
  const Terms<double> terms = terms_of(view, point, material);
  return {terms.diffuse.x, terms.specular.x};
}

/// The terms at the origin, seen from and lit along the given unit vectors by a white point light.
inline GreyTerms terms_at(const Vec3d& normal, const Vec3d& to_light, const Vec3d& to_eye,
                          const Material& material) {
  View view;
  view.camera.position = to_eye * 3.0;
  view.lights = {PointLight{to_light * 5.0, {}, {}}};
  return grey_terms(view, {{0, 0, 0}, normal}, material);
}

/// The same on a surface that faces +z.
inline GreyTerms terms_at(const Vec3d& to_light, const Vec3d& to_eye, const Material& material) {
  return terms_at({0, 0, 1}, to_light, to_eye, material);
}

}  // namespace lumaknot
