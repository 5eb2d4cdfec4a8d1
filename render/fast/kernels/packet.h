/// Packets of integers, and gathering.
#pragma once

#include <array>
#include <cstdint>

#include "render/fast/frame_data.h"
#include "render/fast/kernels/rows.h"

namespace lumaknot::fast {

/// 0, 1, 2, ...
template <class A>
Ints<A> lane_numbers() {
  alignas(64) std::int32_t numbers[Ints<A>::size];
  for (std::size_t i = 0; i < Ints<A>::size; ++i) numbers[i] = std::int32_t(i);
  return Ints<A>::load_aligned(numbers);
}

/// A packet of pixels is a block of kBlockWidth x (lanes / kBlockWidth), its lanes row by row; a
/// tile's blocks lie row by row too. Small triangles touch fewer blocks than rows.
inline constexpr int kBlockWidth = 4;
template <class A>
inline constexpr int kBlockHeight = int(Ints<A>::size) / kBlockWidth;

/// Each lane's column and row in its block.
template <class A>
Ints<A> lane_columns() {
  return lane_numbers<A>() & Ints<A>(kBlockWidth - 1);
}
template <class A>
Ints<A> lane_rows() {
  return lane_numbers<A>() >> 2;
}

/// The start of the block that contains the pixel (x, y) of a tile.
template <class A>
std::size_t block_begin(int x, int y) {
  const int block = y / kBlockHeight<A> * (kTile / kBlockWidth) + x / kBlockWidth;
  return std::size_t(block) * Ints<A>::size;
}

template <class A>
Floats<A> to_floats(const Ints<A>& x) {
  return xsimd::to_float(x);
}

/// Truncated; must be in range.
template <class A>
Ints<A> to_ints(const Floats<A>& x) {
  return xsimd::to_int(x.v);
}

template <class A>
Floats<A> floor(const Floats<A>& x) {
  return xsimd::floor(x.v);
}

/// The lowest 32 bits of the products.
template <class A>
Ints<A> wrapped_product(const Ints<A>& a, const Ints<A>& b) {
  using Unsigned = xsimd::batch<std::uint32_t, A>;
  const Unsigned product = bits_as<Unsigned>(a) * bits_as<Unsigned>(b);
  return bits_as<Ints<A>>(product);
}

/// values[index] of each lane.
template <class A>
Ints<A> gather(const std::int32_t* values, const Ints<A>& index) {
  return Ints<A>::gather(values, index);
}
#ifdef __AVX512F__
// xsimd 8.1 loads the lanes one after the other.
inline Ints<xsimd::avx512bw> gather(const std::int32_t* values,
                                    const Ints<xsimd::avx512bw>& index) {
  return Ints<xsimd::avx512bw>(_mm512_i32gather_epi32(index, values, 4));
}
#endif

/// values[index] of each lane, from sixteen at an aligned address.
template <class A>
Ints<A> look_up(const std::array<std::int32_t, 16>& values, const Ints<A>& index) {
  return gather(values.data(), index);
}
#ifdef __AVX512F__
template <>
inline Ints<xsimd::avx512bw> look_up<xsimd::avx512bw>(const std::array<std::int32_t, 16>& values,
                                                      const Ints<xsimd::avx512bw>& index) {
  return Ints<xsimd::avx512bw>(_mm512_permutexvar_epi32(index, _mm512_load_si512(values.data())));
}
#endif

/// Each lane's lowest byte.
template <class A>
void store_bytes(const Ints<A>& values, std::uint8_t* to) {
  std::int32_t lanes[Ints<A>::size];
  values.store_unaligned(lanes);
  for (std::size_t i = 0; i < Ints<A>::size; ++i) to[i] = std::uint8_t(lanes[i]);
}
#ifdef __AVX512F__
inline void store_bytes(const Ints<xsimd::avx512bw>& values, std::uint8_t* to) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm512_cvtepi32_epi8(values));
}
#endif

/// The bits as floats.
template <class A>
Floats<A> as_floats(const Ints<A>& bits) {
  return bits_as<typename Floats<A>::Batch>(bits);
}

inline constexpr int kSubpixelBits = 10;
static_assert(kSubpixels == 1 << kSubpixelBits);

/// The first and last pixel that may hold samples of a triangle whose snapped points span `min` to
/// `max`: with one sample per pixel, those whose centres are inside; with more, those that are
/// touched. `I` is an integer or a packet of them.
template <class A, class I>
I first_pixel(const I& min, bool centres) {
  return (min + I(centres ? kSubpixels / 2 - 1 : 0)) >> kSubpixelBits;
}
template <class A, class I>
I last_pixel(const I& max, bool centres) {
  return (max - I(centres ? kSubpixels / 2 : 0)) >> kSubpixelBits;
}

/// The floats' bits.
template <class A>
Ints<A> as_ints(const Floats<A>& x) {
  return bits_as<Ints<A>>(x.v);
}

/// The three corners of each lane's triangle.
template <class A>
std::array<Ints<A>, 3> load_corners(const FrameData& data, const Ints<A>& triangle) {
  const std::array<Ints<A>, 4> row = load_rows<A, 4>(data.triangles.data(), triangle << 2);
  return {row[0], row[1], row[2]};
}

/// The snapped image points of each lane's vertex.
template <class A>
struct SnappedPoints {
  std::array<Ints<A>, 2> at;
  Floats<A> inverse_depth;
};
template <class A>
SnappedPoints<A> load_points(const FrameData& data, const Ints<A>& vertex) {
  static_assert(sizeof(SnappedPoint) == 4 * sizeof(std::int32_t));
  const std::array<Ints<A>, 4> row = load_rows<A, 4>(data.points.data(), vertex << 2);
  return {{row[0], row[1]}, as_floats<A>(row[2])};
}

/// The members of each lane's vertex record, in its order.
template <class A>
std::array<Floats<A>, 8> load_records(const FrameData& data, const Ints<A>& vertex) {
  static_assert(sizeof(VertexRecord) == 8 * sizeof(float));
  const std::array<Ints<A>, 8> row = load_rows<A, 8>(data.records.data(), vertex << 3);
  std::array<Floats<A>, 8> record;
  for (std::size_t c = 0; c < 8; ++c) record[c] = as_floats<A>(row[c]);
  return record;
}

}  // namespace lumaknot::fast
