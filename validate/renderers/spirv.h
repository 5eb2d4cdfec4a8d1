/// Shaders as SPIR-V, through the Khronos compiler glslangValidator.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "shaders/languages/emit.h"
#include "validate/renderers/adapter.h"

namespace lumaknot::validate {

/// A stage of a shader's text.
struct SpirvStage {
  bool is_hlsl = false;
  bool is_fragment = false;  ///< else vertex
  std::string_view entry = "main";
};

/// `text` as SPIR-V. Throws std::runtime_error with the compiler's words, or when it is not found.
std::string compile_spirv(const Programs& programs, std::string_view text, const SpirvStage& stage);

/// How many instructions the functions of a SPIR-V module hold, without labels, variables and what
/// only frames a function. 0 when `spirv` is none.
int instruction_count(std::string_view spirv);

/// Of the fragment stage that emit() makes; nothing when the language has none in SPIR-V or the
/// compiler is not here.
std::optional<int> fragment_instructions(const Programs& programs, const ShaderJob& job,
                                         Language language);

}  // namespace lumaknot::validate
