#include "validate/limits.h"

#include <array>
#include <cassert>

namespace lumaknot {
namespace {

constexpr std::array kLimits{
    Limits{.renderer = "Cycles",
           .coverage = 0,
           .mean = 1e-4,
           .p999 = 2.5e-3,
           .max = 5e-3,
           .outlier = 5e-3,
           .reason = "float32 positions and texture coordinates, and a sample up to 0.005 pixels "
                     "off the centre, inside its narrowest filter"},
    Limits{.renderer = "POV-Ray",
           .coverage = 0,
           .p9999_unclassed = 5e-4,
           .outlier = 5e-4,
           .reason = "float32 mesh; it turns normals to the viewer and draws no highlight where "
                     "n.l < 0, which has classes of its own"},
    Limits{.renderer = "Eevee",
           .coverage = 5,
           .mean = 1e-3,
           .p999 = 2e-2,
           .reason = "vertices snapped to 1/256 pixel by the OpenGL rasteriser; the texture is "
                     "fetched texel by texel, since its own filter always takes mipmaps"},
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
