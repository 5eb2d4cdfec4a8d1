/// Scenes that nobody chose.
#pragma once

#include <cstdint>

#include "meshgen/knot_mesh.h"
#include "scene/spec.h"

namespace lumaknot::verdicts {

struct RandomScene {
  Scene scene;
  KnotSpec knot;  ///< of its mesh
};

/// A knot or link of up to 5 turns, one to three lights of any kind, any formula, a camera that
/// sees it, bricks, a random texture or one colour, 64 to 128 pixels wide and high. The same for
/// the same seed on every machine.
RandomScene random_scene(std::uint64_t seed);

}  // namespace lumaknot::verdicts
