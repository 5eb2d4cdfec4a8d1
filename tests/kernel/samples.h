/// Surfaces, eyes, lights and numbers for kernel runs.
#pragma once

#include <array>
#include <vector>

#include "scene/spec.h"

namespace lumaknot::testing {

inline constexpr std::size_t kKernelRows = 4096;

inline constexpr std::size_t kMaxLights = 3;

struct LightSample {
  Vec3d to_light;  ///< unit
  Vec3d position;
  Vec3d aim;  ///< a spot's direction, unit, at the surface more or less
  Vec3d color;
  Falloff falloff;
  double cos_outer = 0, cone_scale = 1;
};

/// A surface, eye, lights and numbers, enough for every formula.
struct Sample {
  Vec3d position, normal, eye, texture;
  std::array<LightSample, kMaxLights> lights;
  Vec3d ambient, diffuse, specular, emissive;
  double shininess = 0, roughness = 0, reflectance = 0, darkness = 0, luma_offset = 0;
};

/// kKernelRows of them from one seed, the same for every shader: eyes in the mirror image of a
/// light in every second row, colours and numbers often at the ends of their ranges, and in every
/// fourth of the first half something at an edge: eye or light at the surface, grazing, no normal,
/// l = -v.
const std::vector<Sample>& kernel_samples();

}  // namespace lumaknot::testing
