/// What samples see: the nearest triangle of those drawn so far.
#pragma once

#include "render/fast/kernels/packet.h"

namespace lumaknot::fast {

/// A packet of samples in memory, two integers each: the bits of 1 / depth, 0 where there is
/// nothing, and the triangle. Inverse depths are not negative, so their bits compare as they do.
template <class A>
struct Nearest {
  static constexpr std::size_t kWidth = Ints<A>::size;

  static void clear(std::int32_t* packet) {
    Ints<A>(0).store_aligned(packet);
    Ints<A>(kNothing).store_aligned(packet + kWidth);
  }

  /// Keeps `triangle` where `mask` is set and it is not behind. Packets are aligned, so that the
  /// next triangle can load at once what one stores.
  static void keep(const xsimd::batch_bool<std::int32_t, A>& mask, const Floats<A>& depth,
                   std::uint32_t triangle, std::int32_t* packet) {
    const Ints<A> old = Ints<A>::load_aligned(packet);
    const Ints<A> bits = as_ints<A>(depth);
    const auto passes = mask && bits >= old;
    xsimd::select(passes, bits, old).store_aligned(packet);
    const Ints<A> before = Ints<A>::load_aligned(packet + kWidth);
    xsimd::select(passes, Ints<A>(std::int32_t(triangle)), before).store_aligned(packet + kWidth);
  }

  /// The triangles.
  static Ints<A> seen(const std::int32_t* packet) { return Ints<A>::load_aligned(packet + kWidth); }
  static std::int32_t seen(const std::int32_t* packet, int lane) {
    return packet[int(kWidth) + lane];
  }
};

#ifdef __AVX512F__
/// 64-bit words, the depth in the upper half, the triangle in the lower: one comparison decides
/// both.
struct Keys {
  __m512i first, second;  ///< of eight samples
};

static Keys keys_of(const Ints<xsimd::avx512bw>& depths, const Ints<xsimd::avx512bw>& triangles) {
  const __m512i low = _mm512_setr_epi32(0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
  const __m512i high = _mm512_add_epi32(low, _mm512_set1_epi32(8));
  return {_mm512_permutex2var_epi32(triangles, low, depths),
          _mm512_permutex2var_epi32(triangles, high, depths)};
}

/// Sort keys, which draw_tiny() compares one by one.
template <>
struct Nearest<xsimd::avx512bw> {
  using Lanes = xsimd::avx512bw;

  static void clear(std::int32_t* packet) {
    const __m512i none = _mm512_set1_epi64(std::uint32_t(kNothing));
    _mm512_store_si512(packet, none);
    _mm512_store_si512(packet + 16, none);
  }

  static void keep(const xsimd::batch_bool<std::int32_t, Lanes>& mask, const Floats<Lanes>& depth,
                   std::uint32_t triangle, std::int32_t* packet) {
    const Keys keys = keys_of(as_ints<Lanes>(depth), Ints<Lanes>(std::int32_t(triangle)));
    const std::uint32_t lanes = std::uint32_t(__mmask16(mask));
    keep_half(__mmask8(lanes), keys.first, packet);
    keep_half(__mmask8(lanes >> 8), keys.second, packet + 16);
  }

  static Ints<Lanes> seen(const std::int32_t* packet) {
    const __m512i even =
        _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    return Ints<Lanes>(
        _mm512_permutex2var_epi32(_mm512_load_si512(packet), even, _mm512_load_si512(packet + 16)));
  }
  static std::int32_t seen(const std::int32_t* packet, int lane) {
    return packet[2 * std::ptrdiff_t(lane)];
  }

 private:
  /// Where depths are equal the later triangle stays, whatever its number.
  static void keep_half(__mmask8 mask, const __m512i& keys, std::int32_t* half) {
    const __m512i as_last = _mm512_or_si512(keys, _mm512_set1_epi64(0xffffffff));
    const __mmask8 passes = _mm512_mask_cmpge_epu64_mask(mask, as_last, _mm512_load_si512(half));
    _mm512_mask_store_epi64(half, passes, keys);
  }
};
#endif

}  // namespace lumaknot::fast
