#include "validate/renderers/spirv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "system/atomic_file.h"
#include "system/process.h"
#include "validate/renderers/external.h"

namespace lumaknot::validate {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> arguments(const fs::path& program, const SpirvStage& stage) {
  std::vector<std::string> list{program.string(), "-V", "-S", stage.is_fragment ? "frag" : "vert"};
  if (stage.is_hlsl) {
    for (const char* flag : {"-D", "-e"}) list.emplace_back(flag);
    list.emplace_back(stage.entry);
    // HLSL numbers buffers, textures and samplers each from 0; Vulkan has one row of bindings.
    for (const char* flag : {"--shift-texture-binding", "1", "--shift-sampler-binding", "3"}) {
      list.emplace_back(flag);
    }
  }
  for (const char* flag : {"-o", "shader.spv", "shader.txt"}) list.emplace_back(flag);
  return list;
}

}  // namespace

std::string compile_spirv(const Programs& programs, std::string_view text,
                          const SpirvStage& stage) {
  const fs::path program = find_program(programs.path(kGlslangProgram));
  if (program.empty()) {
    throw std::runtime_error(not_found(programs, kGlslangProgram));
  }
  const PrivateFolder folder;
  write_file(folder.path() / "shader.txt", std::string(text), "the compiler's folder");
  const ProcessResult ended =
      run({arguments(program, stage), folder.path(), {}}, std::chrono::seconds(60));
  if (!ended.succeeded()) throw std::runtime_error("glslangValidator: " + ended.log);
  return read_file(folder.path() / "shader.spv", "glslangValidator");
}

int instruction_count(std::string_view spirv) {
  // Of the SPIR-V specification 1.6, section 3.52.
  constexpr std::uint16_t kFunction = 54, kFunctionParameter = 55, kFunctionEnd = 56,
                          kVariable = 59, kLabel = 248, kReturn = 253, kReturnValue = 254;
  constexpr std::array kFrames{kFunctionParameter, kVariable, kLabel, kReturn, kReturnValue};
  constexpr std::size_t kHeaderWords = 5;
  std::vector<std::uint32_t> words(spirv.size() / 4);
  if (!words.empty()) std::memcpy(words.data(), spirv.data(), words.size() * 4);
  int count = 0;
  bool in_function = false;
  for (std::size_t i = kHeaderWords; i < words.size();) {
    const auto opcode = std::uint16_t(words[i] & 0xffff);
    const std::uint32_t length = words[i] >> 16;
    if (length == 0) return 0;
    if (opcode == kFunctionEnd) in_function = false;
    if (in_function && std::ranges::count(kFrames, opcode) == 0) ++count;
    if (opcode == kFunction) in_function = true;
    i += length;
  }
  return count;
}

std::optional<int> fragment_instructions(const Programs& programs, const ShaderJob& job,
                                         Language language) {
  const bool is_hlsl = language == Language::kHlsl;
  if (!is_hlsl && language != Language::kGlsl450) return std::nullopt;
  if (find_program(programs.path(kGlslangProgram)).empty()) return std::nullopt;
  const Emission files = emit(job, language);
  const SpirvStage stage{is_hlsl, true, is_hlsl ? "fragment_main" : "main"};
  return instruction_count(compile_spirv(programs, files[is_hlsl ? 0 : 1].text, stage));
}

}  // namespace lumaknot::validate
