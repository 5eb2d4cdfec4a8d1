// Errors of the drivers' functions against double: the basis of the bounds on emitted shaders.
#include <cmath>
#include <functional>
#include <random>

#include "tests/gpu/testing.h"

namespace lumaknot::gpu {
namespace {

constexpr int kSide = 128;            // inputs: 128 x 128
constexpr double kHalfUlp = 0x1p-24;  // the largest relative error of one rounding

using Two = std::function<double(double, double)>;

class Functions : public EachApi {
 protected:
  /// The largest |got - want| / bound over random inputs, log-uniform in [low, high] for the
  /// first and uniform in [0, second] for the other.
  double worst(const std::string& glsl, double low, double high, double second, const Two& want,
               const Two& bound) {
    const std::vector<float> inputs = make_inputs(low, high, second);
    set_size(kSide, kSide);
    job_["textures"].clear();
    job_["draws"].clear();
    add_texture("inputs", kSide, kSide, "nearest", inputs);
    const std::vector<Pixel> image = shaded(
        "vec4 a = texelFetch(inputs, ivec2(gl_FragCoord.xy), 0);\n"
        "color = vec4(" +
        glsl + ", a.xy, 1.0);");
    double max = image.empty() ? INFINITY : 0;
    for (const Pixel& p : image) {
      const double x = p[1], y = p[2], error = std::abs(p[0] - want(x, y)) / bound(x, y);
      max = std::isnan(error) ? INFINITY : std::max(max, error);
    }
    return max;
  }

 private:
  static std::vector<float> make_inputs(double low, double high, double second) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> first(std::log(low), std::log(high)), other(0, second);
    std::vector<float> inputs;
    for (int i = 0; i < kSide * kSide; ++i) {
      inputs.insert(inputs.end(),
                    {float(std::exp(first(random))), float(other(random)), 0.0f, 1.0f});
    }
    return inputs;
  }
};

TEST_P(Functions, square_root_and_division_round_once) {
  const auto root = [](double x, double) { return std::sqrt(x); };
  const auto root_bound = [](double x, double) { return kHalfUlp * std::sqrt(x); };
  EXPECT_LE(worst("sqrt(a.x)", 1e-6, 1e6, 1, root, root_bound), 1.0);
  const auto ratio = [](double x, double y) { return (y + 0.5) / x; };
  // The sum, then the quotient.
  const auto ratio_bound = [](double x, double y) { return 2.01 * kHalfUlp * (y + 0.5) / x; };
  EXPECT_LE(worst("(a.y + 0.5) / a.x", 1e-3, 1e3, 9, ratio, ratio_bound), 1.0);
}

// Mesa computes exp2 and log2 by polynomials: measured 2.6e-7 relative, and 1.9e-7 absolute next to
// 1 plus the result's rounding. The limits are twice that.
constexpr double kExp2 = 5e-7, kLog2 = 4e-7;

TEST_P(Functions, exponential_and_logarithm_are_polynomials_of_float_precision) {
  const auto exp2 = [](double x, double y) { return std::exp2(y - x); };
  const auto exp2_bound = [](double x, double y) {
    // The difference is rounded first: ln 2 (y - x) 2^-24.
    return (kExp2 + std::abs(y - x) * kHalfUlp) * std::exp2(y - x);
  };
  EXPECT_LE(worst("exp2(a.y - a.x)", 1e-3, 20, 20, exp2, exp2_bound), 1.0);
  const auto log2 = [](double x, double) { return std::log2(x); };
  const auto log2_bound = [](double x, double) {
    return kLog2 + 2 * kHalfUlp * std::abs(std::log2(x));
  };
  EXPECT_LE(worst("log2(a.x)", 1e-3, 1e3, 1, log2, log2_bound), 1.0);
}

/// pow(x, y) = exp2(y log2 x): the logarithm's error grows with y.
double pow_bound(double x, double y) {
  const double exponent = std::abs(y * std::log2(x));
  return (0.6932 * (y * kLog2 + exponent * 3 * kHalfUlp) + kExp2) * std::pow(x, y) + 1e-37;
}

TEST_P(Functions, power_errs_in_proportion_to_its_exponent) {
  const auto power = [](double x, double y) { return std::pow(x, y); };
  EXPECT_LE(worst("pow(a.x, a.y)", 1e-3, 1, 128, power, pow_bound), 1.0);
  // Highlights: seen on a scale of 1, shininess 55 errs by no more than this.
  const auto highlight = [](double x, double) { return std::pow(x, 55); };
  EXPECT_LE(worst("pow(a.x, 55.0)", 0.5, 1, 1, highlight, [](double, double) { return 1.6e-5; }),
            1.0);
}

TEST_P(Functions, normalized_vectors_have_length_one) {
  const auto one = [](double, double) { return 1.0; };
  // Three squares, two sums, a reciprocal root (1.5 half units), three products; then dot's own.
  const auto bound = [](double, double) { return 16 * kHalfUlp; };
  const std::string unit = "normalize(vec3(a.x, a.y, 0.5))";
  EXPECT_LE(worst("dot(" + unit + ", " + unit + ")", 1e-3, 1e3, 10, one, bound), 1.0);
}

TEST_P(Functions, maximum_and_clamp_take_the_number_beside_a_nan) {
  const std::vector<float> zero{0, 0, 0, 0};
  add_texture("inputs", 1, 1, "nearest", zero);
  const std::vector<Pixel> image = shaded(
      "float z = texelFetch(inputs, ivec2(0), 0).x;\n"
      "color = vec4(max(z / z, 0.0), clamp(z / z, 0.0, 1.0), pow(z, 55.0), 1.0);");
  EXPECT_EQ(image.at(0), (Pixel{0, 0, 0, 1}));
}

INSTANTIATE_TEST_SUITE_P(Gpu, Functions, ::testing::Values("gl", "gles", "vulkan"), api_name);

}  // namespace
}  // namespace lumaknot::gpu
