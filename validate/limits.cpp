#include "validate/limits.h"

#include <array>
#include <cassert>

namespace lumaknot {
namespace {

/// Emitted shaders on a rasteriser of the OpenGL kind.
constexpr Limits gpu_limits(std::string_view name) {
  return {.renderer = name,
          .edge = 1.0 / 128,
          .mean = 5e-4,
          .p999 = 5e-3,
          .outlier = 5e-3,
          .unexplained = 5,
          .reason =
              "the rasteriser snaps vertices to a grid of 1/256 pixel: that moves what a sample "
              "sees by up to 0.004 pixel, and turns the plane of triangles thinner than the grid; "
              "positions, normals and texture coordinates are interpolated in float32"};
}

constexpr std::array kLimits{
    Limits{.renderer = "Cycles",
           .edge = 1e-3,
           .mean = 5e-4,
           .p999 = 5e-3,
           .outlier = 5e-3,
           .reason = "positions, normals and texture coordinates in float32: a few units in the "
                     "last place are a thousandth of a texel at twenty tiles of a hundred, times "
                     "the texture's steps, up to 1"},
    Limits{.renderer = "OSL",
           .edge = 1e-3,
           .mean = 5e-4,
           .p999 = 5e-3,
           .outlier = 5e-3,
           .reason = "as in Cycles, float32; and the fast pow of OSL's library errs by 1.4e-5 + "
                     "1.8e-7 times the exponent of its value"},
    Limits{.renderer = "POV-Ray",
           .edge = 1e-3,
           .p9999 = 5e-4,
           .outlier = 5e-4,
           .reason = "float32 mesh; it turns normals to the viewer and draws no highlight where "
                     "n.l < 0, which has classes of its own"},
    Limits{.renderer = "Eevee",
           .edge = 1.0 / 128,
           .mean = 5e-4,
           .p999 = 5e-3,
           .outlier = 2e-2,
           .unexplained = 5,
           .reason =
               "the OpenGL rasteriser snaps vertices to a grid of 1/256 pixel: that moves what "
               "a sample sees by up to 0.004 pixel, and turns the plane of triangles thinner "
               "than the grid; half-float buffers from 4.2 on. The texture is fetched texel "
               "by texel, since its own filter always takes mipmaps"},
    gpu_limits("GL"),
    gpu_limits("GLES"),
    gpu_limits("Vulkan"),
    gpu_limits("HLSL"),
};

}  // namespace

const Limits& limits_of(std::string_view name) {
  for (const Limits& limits : kLimits) {
    if (limits.renderer == name) return limits;
  }
  assert(!"every renderer has its limits");
  return kLimits.front();
}

}  // namespace lumaknot
