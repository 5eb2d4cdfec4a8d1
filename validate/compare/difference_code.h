/// Differences of pictures in a byte per channel, so that a page can rebuild one picture from
/// another, and both values of a pixel.
#pragma once

#include <cstdint>
#include <string>

#include "scene/image.h"

namespace lumaknot::validate {

/// A code of n, in [-127, 127], means step * sinh(kCodeBend * n) / kCodeBend: linear near 0, where
/// it is right to half a step, and logarithmic beyond, where it is right to 4.5 %.
inline constexpr double kCodeBend = 0.09;

/// The nearest code of a difference; one beyond the last code's becomes the last.
std::int8_t difference_code(double difference, double step);

/// The difference that a code means.
double decoded_difference(int code, double step);

/// A picture of differences, coded.
struct CodedDifference {
  std::string png;  ///< 8 bits, a channel's code as a two's complement
  double step = 0;
  int block = 1;  ///< a pixel is the mean of block x block differences
};

/// The finest step used: what it leaves out is invisible at a gain of 256.
inline constexpr double kFinestStep = 1.0 / 65536;

/// `differences` at the finest step, of kFinestStep times powers of four up to 1/64, whose file has
/// at most `budget` bytes. If none has, at 1/64, in blocks as large as four times `budget` asks
/// for.
CodedDifference coded_differences(const Grid<Rgb>& differences, std::size_t budget);

}  // namespace lumaknot::validate
