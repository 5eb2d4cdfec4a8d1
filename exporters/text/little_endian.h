/// Numbers in little-endian binary files.
#pragma once

#include <bit>
#include <cstring>

#include "math/vec.h"

namespace lumaknot {

static_assert(std::endian::native == std::endian::little, "numbers are written without conversion");

/// Puts the bytes of `value` at `at` and returns their end.
template <class T>
char* put_bytes(char* at, const T& value) {
  std::memcpy(at, &value, sizeof(T));
  return at + sizeof(T);
}

/// Three float32.
inline char* put_floats(char* at, const Vec3d& v) {
  return put_bytes(at, Vec3<float>{float(v.x), float(v.y), float(v.z)});
}

}  // namespace lumaknot
