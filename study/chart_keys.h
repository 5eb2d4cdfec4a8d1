/// What results were measured of, as short keys: what is kept of others is measured anew.
#pragma once

#include <string>

#include "scene/scene.h"

namespace lumaknot {

/// Of all numbers, the mesh and the texture's pixels.
std::string scene_key(const Scene& scene, const MeshSpec& mesh);

/// Of this program's file, the processor's cores and its name.
std::string program_key();

}  // namespace lumaknot
