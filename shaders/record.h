/// Lighting formulas as recorded graphs.
#pragma once

#include "scene/shot.h"
#include "shaders/expression.h"

namespace lumaknot {

/// What `shot` computes from the inputs position, normal and texture, the scene's numbers kept as
/// named parameters.
NodePtr record_shot(const View& view, const Shot& shot);

}  // namespace lumaknot
