/// How precise the languages' arithmetic is, besides LibraryErrors and VulkanErrors.
#pragma once

#include "tests/shaders/graph/rounding_bound.h"

namespace lumaknot::testing {

/// Cycles' nodes: the C library's functions, but a logarithm is log(x) / log(e) with e a float.
struct CyclesErrors : rounding::LibraryErrors {
  static double logarithm(double x) { return 5.5 * kRounding * std::abs(std::log(x)); }
};

/// Measured in Blender 5.0's OSL, whose pow, exp and log are polynomials (OpenImageIO's
/// fast_math.h).
struct OslErrors : rounding::LibraryErrors {
  static double exponential(double) { return 1.5e-5; }
  static double logarithm(double) { return 1.2e-6; }
  static double power(double, double exponent) { return 1.4e-5 + 1.8e-7 * exponent; }
};

/// A C library in double.
struct DoubleErrors {
  static constexpr double kRounding = 0x1p-53;
  static double division() { return kRounding; }
  static double root() { return kRounding; }
  static double exponential(double) { return 2 * kRounding; }
  static double logarithm(double x) { return 2 * kRounding * std::abs(std::log(x)); }
  static double power(double, double) { return 2 * kRounding; }
};

}  // namespace lumaknot::testing
