/// Scenes for Blender 3.4 to 5.x: a Python script with the numbers, a binary mesh file, and the
/// lighting formula as shader nodes into an Emission.
#pragma once

#include <span>

#include "exporters/package.h"
#include "scene/shot.h"
#include "scene/spec.h"

namespace lumaknot::blender {

/// The shaders that compute the colours of the shots.
enum class ShotShaders {
  kNodes,  ///< shader nodes
  kOsl     ///< the emitted OSL, NAME.SHOT.osl: Cycles only, in a Blender built with OSL
};

/// NAME.py with NAME.mesh.bin and, unless the texture is a plain colour, the images that the shots
/// read: NAME.texture.png and, for each space that it is baked in, NAME.SPACE.axes.exr. One
/// material per shot. Run as `blender --python NAME.py`; after `--` it takes --engine cycles|eevee,
/// --render SHOT=FILE.exr, --save FILE.blend, and for random samples in Cycles --samples N, --seed
/// N and --denoise. Throws Error for a shot that Blender can't draw.
Package blender_package(const Scene& scene, std::span<const Shot> shots, const std::string& name,
                        ShotShaders shaders = ShotShaders::kNodes);

/// lumaknot_nodes.py, which builds emitted recipes as node groups.
std::string_view blender_nodes_loader();

}  // namespace lumaknot::blender
