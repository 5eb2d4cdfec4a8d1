/// Emitted shaders run in the programs of their languages, on rows of numbers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "shaders/languages/backend.h"
#include "tests/kernel/rows.h"

namespace lumaknot::testing {

/// A shader, its text in a language, and its rows.
struct Kernel {
  Shader shader;
  std::string code;  ///< kernel_code()
  KernelRows rows;
};

/// A colour for each row.
using Colors = std::vector<Vec3d>;

/// The code of `shader` that runs in `language`: emit_kernel()'s fragment stage for GLSL and HLSL,
/// else the first file of emit(). No program runs effects (kFx).
std::string kernel_code(const Shader& shader, Language language);

/// The colours of each kernel. Throws std::runtime_error.
std::vector<Colors> run_kernels(std::span<const Kernel> kernels, Language language);

/// Why `language` can't run here, with the remedy; empty if it can.
std::string missing_for(Language language);

/// Whether what runs `language` is an extra (scripts/install-extras), whose tests may be skipped.
/// The others' programs are installed by ./check: without one its tests fail.
inline bool is_extra(Language language) { return language == Language::kOsl; }

/// By lumaknot-gpu: GLSL and HLSL.
std::vector<Colors> run_on_gpu(std::span<const Kernel> kernels, Language language);
std::string missing_for_gpu(Language language);

/// In Cycles: kBlender and kOsl.
std::vector<Colors> run_in_cycles(std::span<const Kernel> kernels, Language language);
std::string missing_for_cycles(Language language);

/// The bytes of a column: four floats per row.
std::string column_bytes(const KernelColumn& column);

}  // namespace lumaknot::testing
