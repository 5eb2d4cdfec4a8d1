/// The numbers that a kernel run feeds a shader, a few thousand rows of them, and the formula's
/// result for a row in double.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "shaders/languages/emit.h"
#include "tests/kernel/samples.h"

namespace lumaknot::testing {

inline constexpr int kKernelSide = 64;  ///< pixels of the image that a kernel draws

/// One value that a kernel reads, for each row; a scalar in x. All are floats.
struct KernelColumn {
  std::string name;
  bool is_vector = true;
  std::vector<Vec3d> values;
};

/// The columns of a shader, in the order of kernel_inputs(). With Form::kBaked "texture" holds the
/// axes of the space.
class KernelRows {
 public:
  explicit KernelRows(std::vector<KernelColumn> columns);

  const std::vector<KernelColumn>& columns() const { return columns_; }
  /// The column of that name, or null.
  const KernelColumn* find(const std::string& name) const;

 private:
  std::vector<KernelColumn> columns_;
  std::map<std::string, std::size_t> index_;
};

/// The rows for the shader of `job`: kernel_samples(), rounded to float.
KernelRows kernel_rows(const ShaderJob& job);

/// The colour that the formula of `job` gives for a row, in double.
Vec3d expected_color(const ShaderJob& job, const KernelRows& rows, std::size_t row);

/// "shininess 55, position (0, 1, 0), ...": the row as reported in a failure.
std::string row_text(const KernelRows& rows, std::size_t row);

}  // namespace lumaknot::testing
