#include "shaders/spaces/atd95.h"

namespace lumaknot {

Atd95Model atd95_model(const Atd95Conditions& conditions) {
  const double per_cone =
      power(kTrolands * power(conditions.white_luminance, kTrolandPower), kConePower);
  const Vec3d white_cones = atd95_cones<double>(conditions.white);
  const Vec3d adapted = white_cones * (per_cone * power(conditions.k2, kConePower)) + kAtd95Noise;
  const double sigma = conditions.sigma;
  const Vec3d gain{sigma / (sigma + adapted.x), sigma / (sigma + adapted.y),
                   sigma / (sigma + adapted.z)};
  const Matrix3 from_signals = scale_columns(kAtd95Opponents, gain);
  const Matrix3 from_cones = scale_columns(from_signals, grey(per_cone));
  const Vec3d black = transform<double>(from_signals, kAtd95Noise);
  const Vec3d white = transform<double>(from_cones, white_cones);
  return {from_cones,
          inverse(from_cones),
          {black.x, black.y, black.z},
          {white.x, white.y, white.z},
          final_response(black.x),
          final_response(black.x + white.x)};
}

const Atd95Model& atd95_shading_model() {
  static const Atd95Model model = atd95_model({.white = kWhiteXyz});
  return model;
}

}  // namespace lumaknot
