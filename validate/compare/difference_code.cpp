#include "validate/compare/difference_code.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "exporters/image/file.h"
#include "validate/compare/blocks.h"

namespace lumaknot::validate {
namespace {

std::string coded_png(const Grid<Rgb>& differences, double step) {
  std::vector<std::uint8_t> codes;
  codes.reserve(3 * differences.pixels.size());
  for (const Rgb& d : differences.pixels) {
    for (const float v : {d.r, d.g, d.b}) {
      codes.push_back(std::uint8_t(difference_code(double(v), step)));
    }
  }
  return smallest_png(differences.width, differences.height, 3, codes);
}

/// Whether a few bands of the picture show that its file would exceed `budget` by far.
bool is_hopeless(const Grid<Rgb>& differences, double step, std::size_t budget) {
  constexpr int kBand = 16, kEvery = 5;
  Grid<Rgb> bands(differences.width, 0);
  for (int y = 0; y < differences.height; ++y) {
    if (y / kBand % kEvery != 0) continue;
    const Rgb* row = &differences.at(0, y);
    bands.pixels.insert(bands.pixels.end(), row, row + differences.width);
    ++bands.height;
  }
  const auto height = std::size_t(differences.height), tried = std::size_t(bands.height);
  return coded_png(bands, step).size() * height > 2 * budget * tried;
}

}  // namespace

std::int8_t difference_code(double difference, double step) {
  constexpr double kLast = 127;
  if (std::abs(difference) < step / 2) return 0;  // most pixels
  const double code = std::asinh(kCodeBend * difference / step) / kCodeBend;
  return std::int8_t(std::lround(std::clamp(code, -kLast, kLast)));
}

double decoded_difference(int code, double step) {
  return step * std::sinh(kCodeBend * code) / kCodeBend;
}

CodedDifference coded_differences(const Grid<Rgb>& differences, std::size_t budget) {
  constexpr double kCoarsest = 1.0 / 64;
  constexpr int kSteps = 6;
  constexpr std::size_t kMost = 4;
  CodedDifference coded;
  for (int i = 0; i < kSteps; ++i) {
    const double step = std::ldexp(kFinestStep, 2 * i);
    if (step < kCoarsest && is_hopeless(differences, step, budget)) continue;
    coded = {coded_png(differences, step), step};
    if (coded.png.size() <= budget) return coded;
  }
  for (int block = 2; coded.png.size() > kMost * budget && block <= 64; block *= 2) {
    coded = {coded_png(block_means(differences, block, std::identity{}), kCoarsest), kCoarsest,
             block};
  }
  return coded;
}

}  // namespace lumaknot::validate
