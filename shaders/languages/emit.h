/// Complete shaders, ready to paste, in every language.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shaders/graph/shader.h"
#include "shaders/languages/backend.h"

namespace lumaknot {

/// A shader in one language: its files, parameters.json the last.
using Emission = std::vector<EmittedFile>;

/// What keeps `language` from expressing the job, with the nearest thing that works; or nothing.
std::optional<std::string> emission_shortfall(const ShaderJob& job, Language language);

/// Throws Error on a shortfall.
Emission emit(const ShaderJob& job, Language language);

/// A stand-alone fragment shader that computes the shader's colour once a pixel, for 64 x 64 rows
/// of inputs in a texture 4096 wide, a row for each of kernel_inputs(). For languages that have
/// one. The functions in it are, letter for letter, those that emit() prints.
KernelCode emit_kernel(const Shader& shader, Language language);

/// A value that a kernel reads: the surface's, then the parameters.
struct KernelInput {
  std::string name;
  bool is_vector = true;
};
std::vector<KernelInput> kernel_inputs(const Shader& shader);

/// How many operations the formula takes, without what all pixels share.
int operation_count(const Shader& shader);

/// Where the std140 block of `shader` (and HLSL's cbuffer, which packs it the same) holds a
/// parameter, in bytes: three 4 x 4 matrices first.
struct BlockEntry {
  ShaderParameter parameter;
  int offset = 0;
};
std::vector<BlockEntry> parameter_block(const Shader& shader);
inline constexpr int kMatrixBytes = 3 * 64;

}  // namespace lumaknot
