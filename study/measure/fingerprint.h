/// Short keys of what results were measured from: results with other keys are measured again.
#pragma once

#include <string>

#include "scene/spec.h"

namespace lumaknot::measure {

/// The key of all numbers, the mesh and the texture's pixels.
std::string scene_key(const Scene& scene, const MeshSpec& mesh);

/// The key of this program's file and the processor's name and number of cores.
std::string program_key();

}  // namespace lumaknot::measure
