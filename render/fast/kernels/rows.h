/// Loading one row per lane and transposing rows into columns.
#pragma once

#include <array>
#include <cstdint>

#include "render/fast/simd_number.h"

namespace lumaknot::fast {

template <class A>
using Ints = xsimd::batch<std::int32_t, A>;

/// Column c of the result has words[begin + c] of each lane, n words per row.
template <class A, std::size_t n>
struct Rows {
  static std::array<Ints<A>, n> load(const std::int32_t* words, const Ints<A>& begin) {
    constexpr std::size_t kWidth = Ints<A>::size;
    alignas(64) std::int32_t begins[kWidth];
    begin.store_aligned(begins);
    // Otherwise GCC extracts each lane from the register, which is slower than reading it back.
    asm("" : "+m"(begins));
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
/// Two words of each lane's row, in eight bytes per lane: the size that gathers fastest.
inline std::array<Ints<xsimd::avx512bw>, 2> load_pair(const std::int32_t* words,
                                                      const Ints<xsimd::avx512bw>& begin) {
  const __m512i at = begin;
  const __m512i low = _mm512_i32gather_epi64(_mm512_castsi512_si256(at), words, 4);
  const __m512i high = _mm512_i32gather_epi64(_mm512_extracti64x4_epi64(at, 1), words, 4);
  const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
  const __m512i odd = _mm512_or_si512(even, _mm512_set1_epi32(1));
  return {Ints<xsimd::avx512bw>(_mm512_permutex2var_epi32(low, even, high)),
          Ints<xsimd::avx512bw>(_mm512_permutex2var_epi32(low, odd, high))};
}

template <std::size_t n>
struct Rows<xsimd::avx512bw, n> {
  static_assert(n % 2 == 0);
  static std::array<Ints<xsimd::avx512bw>, n> load(const std::int32_t* words,
                                                   const Ints<xsimd::avx512bw>& begin) {
    std::array<Ints<xsimd::avx512bw>, n> result;
    for (std::size_t c = 0; c < n; c += 2) {
      const auto pair = load_pair(words + c, begin);
      result[c] = pair[0];
      result[c + 1] = pair[1];
    }
    return result;
  }
};
#endif

/// As Rows, for words of any type.
template <class A, std::size_t n>
std::array<Ints<A>, n> load_rows(const void* words, const Ints<A>& begin) {
  return Rows<A, n>::load(static_cast<const std::int32_t*>(words), begin);
}

}  // namespace lumaknot::fast
