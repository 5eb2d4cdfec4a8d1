#define E8 1
#define E4 1
/// Loading a row of each lane's and turning rows into columns: what a gather a column would do,
/// with one load a row.
#pragma once

#include <array>
#include <cstdint>

#include "render/simd_number.h"

namespace lumaknot {

template <class A>
using Ints = xsimd::batch<std::int32_t, A>;

/// Column c of the result has words[begin + c] of each lane, n words a row.
template <class A, std::size_t n>
struct Rows {
  static std::array<Ints<A>, n> load(const std::int32_t* words, const std::int32_t* begins) {
    constexpr std::size_t kWidth = Ints<A>::size;
    std::int32_t columns[n][kWidth];
    for (std::size_t k = 0; k < kWidth; ++k) {
      const std::int32_t* row = words + begins[k];
      for (std::size_t c = 0; c < n; ++c) columns[c][k] = row[c];
    }
    std::array<Ints<A>, n> result;
    for (std::size_t c = 0; c < n; ++c) result[c] = Ints<A>::load_unaligned(columns[c]);
    return result;
  }
};

#ifdef __AVX512F__
/// Four registers of floats.
struct FourRegisters {
  __m512 r[4];
};

/// The transpose of each 4 x 4 block of four registers.
template <class A>
FourRegisters transposed_blocks(const FourRegisters& of) {
  const auto& r = of.r;
  const __m512 a = _mm512_unpacklo_ps(r[0], r[1]), b = _mm512_unpackhi_ps(r[0], r[1]);
  const __m512 c = _mm512_unpacklo_ps(r[2], r[3]), d = _mm512_unpackhi_ps(r[2], r[3]);
  return {{_mm512_shuffle_ps(a, c, 0x44), _mm512_shuffle_ps(a, c, 0xee),
           _mm512_shuffle_ps(b, d, 0x44), _mm512_shuffle_ps(b, d, 0xee)}};
}

template <>
struct Rows<xsimd::avx512bw, 4> {
  using A = xsimd::avx512bw;
  static std::array<Ints<A>, 4> load(const std::int32_t* words, const std::int32_t* begins) {
    const auto row = [&](std::size_t k) {
      return _mm_loadu_ps(reinterpret_cast<const float*>(words + begins[k]));
    };
    FourRegisters four;
    auto& r = four.r;
    for (std::size_t k = 0; k < 4; ++k) {
      r[k] = _mm512_castps128_ps512(row(k));
      r[k] = _mm512_insertf32x4(r[k], row(k + 4), 1);
      r[k] = _mm512_insertf32x4(r[k], row(k + 8), 2);
      r[k] = _mm512_insertf32x4(r[k], row(k + 12), 3);
    }
    const FourRegisters t = transposed_blocks<A>(four);
    std::array<Ints<A>, 4> result;
    for (std::size_t c = 0; c < 4; ++c) result[c] = Ints<A>(_mm512_castps_si512(t.r[c]));
    return result;
  }
};

template <>
struct Rows<xsimd::avx512bw, 8> {
  using A = xsimd::avx512bw;
  static std::array<Ints<A>, 8> load(const std::int32_t* words, const std::int32_t* begins) {
    const auto two = [&](std::size_t k) {
      const auto row = [&](std::size_t at) {
        return _mm256_loadu_ps(reinterpret_cast<const float*>(words + begins[at]));
      };
      return _mm512_insertf32x8(_mm512_castps256_ps512(row(k)), row(k + 8), 1);
    };
    // Blocks of `low`: lanes 0-3 of columns 0-3 and 4-7, lanes 8-11 likewise; `high`: 4-7, 12-15.
    const FourRegisters low = transposed_blocks<A>({{two(0), two(1), two(2), two(3)}});
    const FourRegisters high = transposed_blocks<A>({{two(4), two(5), two(6), two(7)}});
    const __m512i even = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
    const __m512i odd = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    std::array<Ints<A>, 8> result;
    for (std::size_t c = 0; c < 4; ++c) {
      const __m512i a = _mm512_castps_si512(low.r[c]), b = _mm512_castps_si512(high.r[c]);
      result[c] = Ints<A>(_mm512_permutex2var_epi64(a, even, b));
      result[c + 4] = Ints<A>(_mm512_permutex2var_epi64(a, odd, b));
    }
    return result;
  }
};

#endif

/// As Rows, with the begins in a packet.
template <class A, std::size_t n>
std::array<Ints<A>, n> load_rows(const void* words, const Ints<A>& begin) {
  alignas(64) std::int32_t begins[Ints<A>::size];
  begin.store_aligned(begins);
  // Or GCC takes each lane out of the register, which is slower than reading it back.
  asm("" : "+m"(begins));
  return Rows<A, n>::load(static_cast<const std::int32_t*>(words), begins);
}

#ifdef __AVX512F__
/// Two words a row are one gather of eight bytes a lane.
inline std::array<Ints<xsimd::avx512bw>, 2> load_pair(const std::int32_t* words, __m512i at) {
  const __m512i low = _mm512_i32gather_epi64(_mm512_castsi512_si256(at), words, 4);
  const __m512i high = _mm512_i32gather_epi64(_mm512_extracti64x4_epi64(at, 1), words, 4);
  const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
  const __m512i odd = _mm512_or_si512(even, _mm512_set1_epi32(1));
  return {Ints<xsimd::avx512bw>(_mm512_permutex2var_epi32(low, even, high)),
          Ints<xsimd::avx512bw>(_mm512_permutex2var_epi32(low, odd, high))};
}
template <>
inline std::array<Ints<xsimd::avx512bw>, 2> load_rows<xsimd::avx512bw, 2>(
    const void* words, const Ints<xsimd::avx512bw>& begin) {
  return load_pair(static_cast<const std::int32_t*>(words), begin);
}
#if E8
template <>
inline std::array<Ints<xsimd::avx512bw>, 8> load_rows<xsimd::avx512bw, 8>(
    const void* words, const Ints<xsimd::avx512bw>& begin) {
  std::array<Ints<xsimd::avx512bw>, 8> r;
  for (int c = 0; c < 8; c += 2) {
    const auto pair = load_pair(static_cast<const std::int32_t*>(words) + c, begin);
    r[c] = pair[0], r[c + 1] = pair[1];
  }
  return r;
}
#endif
#if E4
template <>
inline std::array<Ints<xsimd::avx512bw>, 4> load_rows<xsimd::avx512bw, 4>(
    const void* words, const Ints<xsimd::avx512bw>& begin) {
  std::array<Ints<xsimd::avx512bw>, 4> r;
  for (int c = 0; c < 4; c += 2) {
    const auto pair = load_pair(static_cast<const std::int32_t*>(words) + c, begin);
    r[c] = pair[0], r[c + 1] = pair[1];
  }
  return r;
}
#endif
#endif

}  // namespace lumaknot
