/// SPIR-V checked before a driver sees it: drivers trust it, and crash or draw something else.
#pragma once

#include <cstdint>
#include <vector>

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

/// A draw's shaders as SPIR-V words.
struct SpirvStages {
  std::vector<std::uint32_t> vertex, fragment;
};

/// The draw's modules: valid for Vulkan 1.0, with the entry points that the draw names; every
/// resource, vertex attribute and varying they read exists. Throws Error, or Unavailable with the
/// validator's log.
SpirvStages checked_spirv(const Job& job, const Draw& draw);

}  // namespace lumaknot::gpu
