#include "validate/gpu/spirv.h"

#include <fmt/format.h>

#include <cstring>
#include <spirv-tools/libspirv.hpp>

#include "system/error.h"
#include "validate/gpu/spirv_interface.h"
#include "validate/gpu/unavailable.h"

namespace lumaknot::gpu {
namespace {

constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::size_t kHeaderWords = 5;

std::vector<std::uint32_t> words_of(const Shader& shader) {
  std::vector<std::uint32_t> words(shader.code.size() / 4);
  std::memcpy(words.data(), shader.code.data(), words.size() * 4);
  const bool whole = shader.code.size() % 4 == 0 && words.size() >= kHeaderWords;
  if (whole && words[0] == kMagic) return words;
  throw Error(fmt::format("{} is not a SPIR-V module of this machine's byte order", shader.where));
}

std::vector<std::uint32_t> valid_words(const Shader& shader) {
  std::vector<std::uint32_t> words = words_of(shader);
  std::string log;
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_0);
  tools.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t& at, const char* text) {
        log += fmt::format("{}:{}: {}\n", shader.where, at.index, text);
      });
  if (tools.Validate(words)) return words;
  throw Unavailable(fmt::format("{}{} is not valid SPIR-V", log, shader.where));
}

}  // namespace

SpirvStages checked_spirv(const Job& job, const Draw& draw) {
  SpirvStages stages{valid_words(draw.vertex), valid_words(draw.fragment)};
  const Interface vertex = interface_of(draw.vertex, stages.vertex, Stage::kVertex);
  const Interface fragment = interface_of(draw.fragment, stages.fragment, Stage::kFragment);
  check_resources(job, draw, draw.vertex, vertex);
  check_resources(job, draw, draw.fragment, fragment);
  check_locations(job, draw, vertex, fragment);
  return stages;
}

}  // namespace lumaknot::gpu
