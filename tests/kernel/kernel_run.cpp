#include "tests/kernel/kernel_run.h"

#include "shaders/emit_parts.h"
#include "tests/kernel/pov_kernel.h"

namespace lumaknot::testing {
namespace {

Colors run_in_povray(const Kernel& kernel) {
  std::vector<PovInput> inputs;
  for (const KernelColumn& column : kernel.rows.columns()) {
    inputs.push_back({column.name, column.is_vector, column.values});
  }
  return run_pov_macro(kernel.code, identifier_of(kernel.shader.function, kPovDialect), inputs,
                       kKernelRows);
}

}  // namespace

std::string kernel_code(const Shader& shader, Language language) {
  switch (language) {
    case Language::kBlender:
      return emit_blender(shader).at(0).text;
    case Language::kOsl:
      return emit_osl(shader).at(0).text;
    case Language::kPov:
      return emit_pov(shader);
    default:
      return emit_kernel(shader, language).fragment;
  }
}

std::vector<Colors> run_kernels(std::span<const Kernel> kernels, Language language) {
  switch (language) {
    case Language::kBlender:
    case Language::kOsl:
      return run_in_cycles(kernels, language);
    case Language::kPov: {
      std::vector<Colors> colors;
      for (const Kernel& kernel : kernels) colors.push_back(run_in_povray(kernel));
      return colors;
    }
    default:
      return run_on_gpu(kernels, language);
  }
}

std::string missing_for(Language language) {
  switch (language) {
    case Language::kBlender:
    case Language::kOsl:
      return missing_for_cycles(language);
    case Language::kPov:
      return find_program("povray").empty() ? "povray is not here; apt-get install povray" : "";
    default:
      return missing_for_gpu(language);
  }
}

std::string column_bytes(const KernelColumn& column) {
  std::vector<float> values;
  values.reserve(column.values.size() * 4);
  for (const Vec3d& v : column.values) {
    for (const double x : {v.x, v.y, v.z, 0.0}) values.push_back(float(x));
  }
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

}  // namespace lumaknot::testing
