#include "meshgen/surface.h"

namespace lumaknot {

TubePoint TubeSurface::at(double t, double theta) const {
  const RingFrame frame = spine_.frame(t);
  const CurvePoint point = curve_point(spine_.curve(), t);
  const double rate = length(point.first);
  const Vec3d normal = frame.normal * std::cos(theta) + frame.binormal * std::sin(theta);
  const Vec3d around = frame.binormal * std::cos(theta) - frame.normal * std::sin(theta);
  // A rotation-minimising normal changes along the tangent only; the holonomy, distributed over the
  // arc length, also turns it by a constant angle per unit length.
  const Vec3d bend = point.second - frame.tangent * dot(point.second, frame.tangent);  // |C'| T'
  const double turn = spine_.holonomy() * rate / spine_.length();
  const Vec3d normal_rate = frame.tangent * (-dot(normal, bend) / rate) + around * turn;
  return {frame.position + normal * radius_, normal, point.first + normal_rate * radius_,
          around * radius_};
}

}  // namespace lumaknot
