/// Guth's ATD95: S. L. Guth, "Further applications of the ATD model for color vision", Proc. SPIE
/// 2414, 1995; equations and worked examples as in M. D. Fairchild, "Color Appearance Models", 3rd
/// ed., 2013, chapter 14. The first stage: initial responses, and the final response of A.
///
/// The eye is adapted to white alone (k1 = 0), so every step can be undone.
#pragma once

#include "shaders/spaces/srgb.h"

namespace lumaknot {

/// The adaptation of the eye.
struct Atd95Conditions {
  Vec3d white;                      ///< XYZ, Y = 1
  double white_luminance = 318.31;  ///< Y_0, cd/m2: a white paper under 1000 lux
  double k2 = 50;                   ///< weight of the white; Guth: 15 to 50
  double sigma = 300;               ///< of the gain
};

/// Initial responses A_1i (achromatic), T_1i (red-green), D_1i (blue-yellow), less those of black.
template <class S>
struct Atd95 {
  S a, t, d;
};

/// The numbers derived from the viewing conditions.
struct Atd95Model {
  Matrix3 from_cones, cones_from;         ///< Atd95 of atd95_cones, and its inverse
  Atd95<double> black;                    ///< initial responses of black: noise
  Atd95<double> white;                    ///< less black
  double black_response, white_response;  ///< final responses A_1
};

/// L, M, S of the 0.8th powers of XYZ.
inline constexpr Matrix3 kAtd95Cones =
    scale_rows({{{0.2435, 0.8524, -0.0516}, {-0.3954, 1.1642, 0.0837}, {0, 0.0400, 0.6225}}},
               {0.66, 1.00, 0.43});
inline constexpr Matrix3 kInverseAtd95Cones = inverse(kAtd95Cones);
inline constexpr Matrix3 kAtd95Opponents{{{3.57, 2.64, 0}, {7.18, -6.21, 0}, {-0.7, 0.085, 1}}};
inline constexpr Vec3d kAtd95Noise{0.024, 0.036, 0.31};  ///< added to the cones' 0.7th powers

/// Trolands are 18 (cd/m2)^0.8; cones respond with the 0.7th power.
inline constexpr double kTrolands = 18, kTrolandPower = 0.8, kConePower = 0.7;
/// The initial response whose final response is one half.
inline constexpr double kAtd95Half = 200;

template <class S>
Vec<S> atd95_cones(const Vec<S>& xyz) {
  const Vec<S> trolands = named("trolands", odd_power_of<S>(xyz, kTrolandPower));
  return named("cones", odd_power_of<S>(transform<S>(kAtd95Cones, trolands), kConePower));
}

template <class S>
Atd95<S> atd95_from_xyz(const Vec<S>& xyz, const Atd95Model& m) {
  const Vec<S> r = named("atd", transform<S>(m.from_cones, atd95_cones<S>(xyz)));
  return {x_of(r), y_of(r), z_of(r)};
}

template <class S>
Vec<S> xyz_from_atd95(const Atd95<S>& r, const Atd95Model& m) {
  const Vec<S> cones = transform<S>(m.cones_from, make_vec(r.a, r.t, r.d));
  const Vec<S> linear = named("lit_cones", odd_power_of<S>(cones, 1 / kConePower));
  const Vec<S> trolands = named("lit_trolands", transform<S>(kInverseAtd95Cones, linear));
  return named("lit_xyz", odd_power_of<S>(trolands, 1 / kTrolandPower));
}

/// The luminance Y (white: 1) of the grey whose response is `a`, which grows as Y^(0.8 * 0.7).
template <class S>
S luminance_of_atd95_grey(const S& a, const Atd95Model& m) {
  return odd_power<S>(a * S(1 / m.white.a), 1 / (kTrolandPower * kConePower));
}

/// R / (200 + |R|).
template <class S>
S final_response(const S& initial) {
  return initial / (abs(initial) + S(kAtd95Half));
}

/// The final response of A, 0 for black and 1 for white.
template <class S>
S brightness_of_atd95(const S& a, const Atd95Model& m) {
  const S response = named("final_a", final_response<S>(a + S(m.black.a)));
  return (response - S(m.black_response)) * S(1 / (m.white_response - m.black_response));
}

/// The inverse of brightness_of_atd95 up to white; above it the tangent, since no colour has a
/// final response of 1 (brightness 2.9). Likewise below minus white.
template <class S>
S atd95_of_brightness(const S& brightness, const Atd95Model& m) {
  const double white = m.white_response;
  const S response = brightness * S(white - m.black_response) + S(m.black_response);
  const S inside = named("lit_final_a", max(min(response, S(white)), S(-white)));
  const S initial = inside * S(kAtd95Half) / (S(1) - abs(inside));
  const S beyond = (response - inside) * S(kAtd95Half / ((1 - white) * (1 - white)));
  return named("lit_a", initial + beyond - S(m.black.a));
}

/// The model under `conditions`.
Atd95Model atd95_model(const Atd95Conditions& conditions);

/// The model of the shading space: white D65 of srgb.h at 318.31 cd/m2, k2 = 50.
const Atd95Model& atd95_shading_model();

}  // namespace lumaknot
