/// Scenes for Blender 3.4 to 5.x: a Python script with the numbers, the mesh as a binary array
/// beside it, and the lighting formula as shader nodes into an Emission.
#pragma once

#include <span>

#include "exporters/package.h"
#include "scene/scene.h"
#include "scene/shot.h"

namespace lumaknot {

/// NAME.py with NAME.mesh.bin and, unless the texture is a plain colour, NAME.texture.png. One
/// material a shot. Run as `blender --python NAME.py`; after `--` it takes --engine cycles|eevee,
/// --render SHOT=FILE.exr and --save FILE.blend.
Package blender_package(const Scene& scene, std::span<const Shot> shots, const std::string& name);

}  // namespace lumaknot
