/// GLSL compiled and linked, uniforms set.
#pragma once

#include <epoxy/gl.h>

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

/// The program of one draw. Throws Unavailable with the compiler's log.
GLuint make_program(const Draw& draw);

/// Makes `program` current: sets the draw's uniforms, binds the textures' samplers to units 0, 1,
/// ... in the job's order. What the program does not use is ignored. Throws Error if the program
/// reads what the job does not set, or a uniform of another type.
void use_program(GLuint program, const Job& job, const Draw& draw);

}  // namespace lumaknot::gpu
