#include "tests/kernel/run.h"

#include <fmt/format.h>

#include "shaders/languages/common.h"
#include "tests/kernel/povray.h"

namespace lumaknot::testing {
namespace {

Colors run_in_povray(const Kernel& kernel) {
  std::vector<PovInput> inputs;
  for (const KernelColumn& column : kernel.rows.columns()) {
    inputs.push_back({column.name, column.is_vector, column.values});
  }
  return run_pov_macro(kernel.code,
                       identifier_of(kernel.shader.function, dialect_of(Language::kPov)), inputs,
                       kKernelRows);
}

}  // namespace

std::string kernel_code(const Shader& shader, Language language) {
  if (backend_of(language).kernel) return emit_kernel(shader, language).fragment;
  return backend_of(language).emit(shader).at(0).text;
}

std::vector<Colors> run_kernels(std::span<const Kernel> kernels, Language language) {
  if (backend_of(language).kernel) return run_on_gpu(kernels, language);
  if (language != Language::kPov) return run_in_cycles(kernels, language);
  std::vector<Colors> colors;
  for (const Kernel& kernel : kernels) colors.push_back(run_in_povray(kernel));
  return colors;
}

std::string missing_for(Language language) {
  if (backend_of(language).kernel) return missing_for_gpu(language);
  switch (language) {
    case Language::kBlender:
    case Language::kOsl:
      return missing_for_cycles(language);
    case Language::kPov:
      return find_program("povray").empty()
                 ? "povray not found; install with apt-get install povray"
                 : "";
    default:
      return fmt::format("nothing runs {} here; add it to tests/kernel/run.cpp",
                         backend_of(language).name);
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
