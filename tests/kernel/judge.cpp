#include "tests/kernel/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "tests/kernel/enclosure.h"
#include "tests/kernel/error_models.h"
#include "tests/shaders/graph/rounding_bound.h"

namespace lumaknot::testing {
namespace {

using rounding::Tape;

constexpr double kMaxEnclosed = 0.01;  // of the rows
/// Of full scale: above it the products of roundings, which a first-order bound omits, matter.
constexpr double kFirstOrder = 0.02;

/// The formula as one graph: light computed per vertex is the same light.
Tape tape_of(const ShaderJob& job) {
  ShaderJob pixel = job;
  pixel.shot.material.rate = ShadingFrequency::kPixel;
  return rounding::tape_of(make_shader(pixel).recorded.color);
}

rounding::Inputs inputs_of(const KernelRows& rows, std::size_t row) {
  rounding::Inputs inputs;
  for (const KernelColumn& column : rows.columns()) inputs[column.name] = column.values[row];
  inputs["texture_axes"] = inputs["texture"];
  return inputs;
}

bool is_within(const Vec3d& error, const Vec3d& limit) {
  return std::abs(error.x) <= limit.x && std::abs(error.y) <= limit.y &&
         std::abs(error.z) <= limit.z;
}

std::string text_of(const Vec3d& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

template <class Errors>
class Judge {
 public:
  Judge(const ShaderJob& job, const KernelRows& rows, double tolerance)
      : job_(job), rows_(rows), tolerance_(tolerance), tape_(tape_of(job)) {}

  Verdict operator()(const std::vector<Vec3d>& found) {
    for (std::size_t row = 0; row < kKernelRows; ++row) add(row, found.at(row));
    verdict_.share_within = 1 - double(beyond_) / kKernelRows;
    if (verdict_.failure.empty() && double(verdict_.enclosed) > kMaxEnclosed * kKernelRows) {
      verdict_.failure =
          fmt::format("{} rows at an edge, more than one in a hundred", verdict_.enclosed);
    }
    return verdict_;
  }

 private:
  void add(std::size_t row, const Vec3d& found) {
    const Vec3d expected = expected_color(job_, rows_, row);
    const double scale = std::max(1.0, largest_magnitude(expected));
    const Vec3d error = found - expected;
    const double relative = is_finite(found) ? largest_magnitude(error) / scale : INFINITY;
    if (relative <= tolerance_) return note(verdict_.largest_error, relative);
    ++beyond_;
    const rounding::Inputs inputs = inputs_of(rows_, row);
    const Vec3d bound = rounding::rounding_bound<Errors>(tape_, rounding::values_of(tape_, inputs));
    if (is_within(error, bound) && largest_magnitude(bound) <= kFirstOrder * scale) {
      note(verdict_.largest_bound, largest_magnitude(bound) / scale);
      return note(verdict_.largest_error, relative);
    }
    const Box box = enclosure<Errors>(tape_, inputs);
    if (is_in(found, box)) {
      ++verdict_.enclosed;
      return note(verdict_.largest_enclosed, relative);
    }
    note(verdict_.largest_error, relative);
    if (verdict_.failures++ > 0) return;
    verdict_.failure = fmt::format(
        "{} in place of {}, bound {}, between {} and {}, {}", text_of(found), text_of(expected),
        text_of(bound), text_of({box[0].low, box[1].low, box[2].low}),
        text_of({box[0].high, box[1].high, box[2].high}), row_text(rows_, row));
  }

  static void note(double& max, double value) { max = std::max(max, value); }

  const ShaderJob& job_;
  const KernelRows& rows_;
  double tolerance_;
  Tape tape_;
  Verdict verdict_;
  std::size_t beyond_ = 0;
};

}  // namespace

Precision precision_of(Language language) {
  switch (language) {
    case Language::kBlender:
      return Precision::kCycles;
    case Language::kOsl:
      return Precision::kOsl;
    case Language::kPov:
      return Precision::kDouble;
    default:  // what runs on lumaknot-gpu
      return Precision::kVulkan;
  }
}

Verdict judged(const ShaderJob& job, const KernelRows& rows, const std::vector<Vec3d>& found,
               Precision precision) {
  switch (precision) {
    case Precision::kCycles:
      return Judge<CyclesErrors>(job, rows, kFullScaleTolerance)(found);
    case Precision::kVulkan:
      return Judge<rounding::VulkanErrors>(job, rows, kFullScaleTolerance)(found);
    case Precision::kOsl:
      return Judge<OslErrors>(job, rows, kFullScaleTolerance)(found);
    case Precision::kDouble:
      break;
  }
  return Judge<DoubleErrors>(job, rows, kDoubleTolerance)(found);
}

void add_to_table(const std::string& language, const KernelCell& cell, const Verdict& verdict) {
  const char* path = std::getenv("LUMAKNOT_KERNEL_TABLE");
  if (!path) return;
  std::ofstream(path, std::ios::app) << fmt::format(
      "{}\t{}\t{}\t{:.2e}\t{:.4f}\t{:.2e}\t{}\t{:.2e}\t{}\n", language, cell.formula, cell.variant,
      verdict.largest_error, verdict.share_within, verdict.largest_bound, verdict.enclosed,
      verdict.largest_enclosed, verdict.failures);
}

}  // namespace lumaknot::testing
