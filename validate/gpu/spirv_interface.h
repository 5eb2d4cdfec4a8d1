/// What a SPIR-V entry point reads and writes, held against what a job gives.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

enum class Stage { kVertex, kFragment };

enum class ResourceKind { kUniformBlock, kCombinedSampler, kTexture, kSampler, kOther };

/// Something that the entry point uses from outside.
struct Resource {
  ResourceKind kind = ResourceKind::kOther;
  std::uint32_t set = 0, binding = 0;
  std::size_t size = 0;  ///< bytes of a uniform block
};

struct Interface {
  std::vector<Resource> resources;
  std::set<std::uint32_t> inputs, outputs;  ///< locations
};

/// Of the shader's entry point; what it declares and does not use is left out. `words` must be
/// valid. Throws Error when there is no such entry point.
Interface interface_of(const Shader& shader, const std::vector<std::uint32_t>& words, Stage stage);

/// Throws Error when the job fills no binding with what the shader uses there.
void check_resources(const Job& job, const Draw& draw, const Shader& shader,
                     const Interface& interface);

/// Throws Error when the vertex shader reads an attribute that the mesh lacks, or the fragment
/// shader a varying that the vertex shader does not write, or when it writes no colour.
void check_locations(const Job& job, const Draw& draw, const Interface& vertex,
                     const Interface& fragment);

}  // namespace lumaknot::gpu
