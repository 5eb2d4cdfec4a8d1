// The matrices of eq. 4 and 5.
#include <algorithm>
#include <cmath>

#include "shaders/spaces/srgb.h"
#include "shaders/spaces/yiq.h"
#include "study/paper/formula_claims.h"

namespace lumaknot::paper {
namespace {

Vec3d column(const Matrix3& m, std::size_t i) {
  return {components(m.rows[0])[i], components(m.rows[1])[i], components(m.rows[2])[i]};
}

Vec3d magnitudes(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

double sum_of(const Vec3d& v) { return v.x + v.y + v.z; }

/// The largest difference of a b from the unit matrix.
double from_unit(const Matrix3& a, const Matrix3& b) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      largest = std::max(largest, std::abs(dot(a.rows[i], column(b, j)) - (i == j ? 1 : 0)));
    }
  }
  return largest;
}

/// The largest error of a b from rounding both matrices to their printed decimals.
double rounding_of(const Matrix3& a, const Matrix3& b) {
  constexpr double kHalfUnit = 0.5e-8;
  double max = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double both = sum_of(magnitudes(a.rows[i])) + sum_of(magnitudes(column(b, j)));
      max = std::max(max, kHalfUnit * both);
    }
  }
  return max;
}

/// The minimum and maximum of a row over the RGB cube, which are at corners.
double min_of(const Vec3d& row) {
  return std::min(row.x, 0.0) + std::min(row.y, 0.0) + std::min(row.z, 0.0);
}
double max_of(const Vec3d& row) { return -min_of(-row); }

/// How far the extremes of a row over the RGB cube are from the printed ones.
Measure beyond(const std::string& name, const Vec3d& row, double min, double max) {
  constexpr double kHalfUnit = 0.5e-4;  // of the four printed decimals
  const double off = std::max(std::abs(min_of(row) - min), std::abs(max_of(row) - max));
  return at_most(name + ": extremes beside the printed ones", off, kHalfUnit);
}

}  // namespace

YiqMatrices paper_matrices() {
  const auto row = [](double i, double q) { return Vec3d{1, i, q}; };
  return {{{kYiqFromRgb[0], kYiqFromRgb[1], kYiqFromRgb[2]}},
          {{row(kRgbFromI.x, kRgbFromQ.x), row(kRgbFromI.y, kRgbFromQ.y),
            row(kRgbFromI.z, kRgbFromQ.z)}}};
}

PaperClaim ranges_claim(const YiqMatrices& m) {
  const auto& [y, i, q] = m.from_rgb.rows;
  return {
      "ranges",
      1,
      "Y is in [0, 1], I in [-0.5957, 0.5957] and Q in [-0.5226, 0.5226].",
      "The extremes of eq. 4 over the RGB cube, which its corners take: a range holds when they "
      "round to it.",
      {beyond("Y", y, 0, 1), beyond("I", i, -0.5957, 0.5957), beyond("Q", q, -0.5226, 0.5226)},
      ""};
}

PaperClaim inverse_claim(const YiqMatrices& m) {
  const auto largest = [](double a, double b) { return std::max(a, b); };
  return {"inverse",
          1,
          "Eq. 5 converts back what eq. 4 converts.",
          "The largest entry of M W and W M beside the unit matrix, held to what rounding both to "
          "eight decimals can leave.",
          {at_most("largest difference from the unit matrix",
                   largest(from_unit(m.from_rgb, m.to_rgb), from_unit(m.to_rgb, m.from_rgb)),
                   largest(rounding_of(m.from_rgb, m.to_rgb), rounding_of(m.to_rgb, m.from_rgb)))},
          ""};
}

PaperClaim ones_claim(const YiqMatrices& m) {
  const Vec3d ones = magnitudes(column(inverse(m.from_rgb), 0) - Vec3d{1, 1, 1});
  constexpr double kDigits = 5e-8;  // M's eight decimals, three to a sum, through its inverse
  return {
      "ones",
      1,
      "The first column of the matrix of eq. 5 is all ones: brightness adds to each channel "
      "alike.",
      "From the exact inverse of eq. 4's matrix, and from its rows: greys must have no I and no "
      "Q.",
      {at_most("inverse's first column beside 1", largest_component(ones), kDigits),
       at_most("I of white", std::abs(sum_of(m.from_rgb.rows[1])), kDigits),
       at_most("Q of white", std::abs(sum_of(m.from_rgb.rows[2])), kDigits)},
      ""};
}

PaperClaim luma_claim(const Vec3d& weights) {
  double min = 1e9, max = 0;
  for (int i = 1; i < 216; ++i) {  // the cube in fifths, except black
    const int red = i % 6, green = i / 6 % 6, blue = i / 36;
    const Vec3d rgb{red / 5.0, green / 5.0, blue / 5.0};
    const double luminance = xyz_from_rgb<double>(rgb).y;
    const double ratio = dot(weights, rgb) / encode_srgb<double>(luminance);
    min = std::min(min, ratio);
    max = std::max(max, ratio);
  }
  return {
      "luma",
      1,
      "Luma is proportional to the gamma-corrected luminance of a colour.",
      "Y over sRGB's encoded luminance for 215 colours of the RGB cube: were it proportional, the "
      "ratio would be the same for all. Of greys it is 1. Proportional: within a tenth.",
      {at_most("most ratio over the least", max / min, 1.1), note("least ratio", min),
       note("most ratio", max)},
      ""};
}

}  // namespace lumaknot::paper
