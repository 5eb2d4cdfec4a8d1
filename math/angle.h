/// Angles: radians internally, degrees where people read or write them.
#pragma once

#include <numbers>

namespace lumaknot {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTurn = 2 * kPi;       ///< a full turn, radians
inline constexpr double kDegree = kPi / 180;   ///< radians in a degree
inline constexpr double kDegrees = 180 / kPi;  ///< degrees in a radian

}  // namespace lumaknot
