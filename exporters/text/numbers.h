/// Numbers and words written into a buffer that has room for them, independent of locales.
#pragma once

#include <fmt/compile.h>

#include <cstdint>
#include <cstring>
#include <string_view>

#include "math/vec.h"

namespace lumaknot {

inline constexpr std::size_t kFloatBytes = 17;    ///< -1234567900000000
inline constexpr std::size_t kIntegerBytes = 10;  ///< 4294967295

/// Puts `text` at `at` and returns its end, as all the following functions do.
inline char* put_text(char* at, std::string_view text) {
  std::memcpy(at, text.data(), text.size());
  return at + text.size();
}

/// `value` in float32, in the fewest digits that read back to it: at most kFloatBytes.
inline char* put_float(char* at, double value) {
  return fmt::format_to(at, FMT_COMPILE("{}"), float(value));
}

inline char* put_integer(char* at, std::uint32_t value) {
  return fmt::format_to(at, FMT_COMPILE("{}"), value);
}

/// x, y, z with `between` after x and after y: 3 kFloatBytes + 2.
inline char* put_vector(char* at, const Vec3d& v, char between) {
  at = put_float(at, v.x);
  *at++ = between;
  at = put_float(at, v.y);
  *at++ = between;
  return put_float(at, v.z);
}

/// u, v with `between` between them: 2 kFloatBytes + 1.
inline char* put_vector(char* at, const Vec2d& uv, char between) {
  at = put_float(at, uv.u);
  *at++ = between;
  return put_float(at, uv.v);
}

/// A line with the number of `corners` and each of them, as in PLY and OFF files: kIntegerBytes + 1
/// per corner plus 2.
template <class Corners>
char* put_polygon(char* at, const Corners& corners) {
  at = put_integer(at, std::uint32_t(corners.size()));
  for (const std::uint32_t corner : corners) {
    *at++ = ' ';
    at = put_integer(at, corner);
  }
  *at++ = '\n';
  return at;
}

}  // namespace lumaknot
