/// GLSL compiled and linked, uniforms set.
#pragma once

#include <epoxy/gl.h>

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

/// The program of one draw. Throws Unavailable with the compiler's log.
GLuint make_program(const Draw& draw);

/// Puts `program` in use: the draw's uniforms set, the textures' samplers tied to units 0, 1, ...
/// in the job's order. What the program has no use for is ignored. Throws Error when the program
/// reads what the job does not give, or a uniform of another type.
void use_program(GLuint program, const Job& job, const Draw& draw);

}  // namespace lumaknot::gpu
