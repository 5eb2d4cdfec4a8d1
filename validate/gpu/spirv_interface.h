/// The interface of a SPIR-V entry point, checked against what a job provides.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

enum class Stage { kVertex, kFragment };

enum class ResourceKind { kUniformBlock, kCombinedSampler, kTexture, kSampler, kOther };

/// An external resource that the entry point uses.
struct Resource {
  ResourceKind kind = ResourceKind::kOther;
  std::uint32_t set = 0, binding = 0;
  std::size_t size = 0;  ///< bytes of a uniform block
};

struct Interface {
  std::vector<Resource> resources;
  std::set<std::uint32_t> inputs, outputs;  ///< locations
};

/// The interface of the shader's entry point, without what it declares but does not use. `words`
/// must be valid. Throws Error if there is no such entry point.
Interface interface_of(const Shader& shader, const std::vector<std::uint32_t>& words, Stage stage);

/// Throws Error if the job lacks a resource at a binding that the shader uses.
void check_resources(const Job& job, const Draw& draw, const Shader& shader,
                     const Interface& interface);

/// Throws Error if the vertex shader reads an attribute that the mesh lacks, or the fragment shader
/// reads a varying that the vertex shader does not write, or writes no colour.
void check_locations(const Job& job, const Draw& draw, const Interface& vertex,
                     const Interface& fragment);

}  // namespace lumaknot::gpu
