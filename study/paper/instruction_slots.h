/// The instruction slots of Direct3D 9's shader model 2 that a formula needs, from its graph.
#pragma once

#include "shaders/graph/shader.h"

namespace lumaknot::paper {

/// Slots of ps_2_0 for the pixel's formula, written with the model's own instructions: dp3, mad,
/// mul, add, max, min 1; nrm, pow 3; rcp and rsq 1, so a quotient 2 and a root 2; exp and log 2
/// with the change of base; a choice 2; crs 2. A sum of a product that nothing else reads is one
/// mad. Saturating is a modifier of the instruction before unless its unsaturated value is read
/// too. Swizzles, negation and putting components together are free. One slot for the texture; two
/// for alpha and the output.
int pixel_slots(const Shader& shader);

/// Slots of vs_2_0 for Table 1's vertex shader: three matrix products (m4x3, m3x3, m4x4), one nrm
/// and two moves.
inline constexpr int kTable1VertexSlots = 3 + 3 + 4 + 3 + 2;

}  // namespace lumaknot::paper
