/// Times a job's frames.
#pragma once

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

/// Draws the job's frames, each timed until the driver has finished it; the image stays in the
/// driver's memory. Then writes one more frame of each draw and prints a line of JSON: renderer
/// (GL's name for it), samples (as drawn), and draws, each with its name and the milliseconds of
/// each frame. Throws Unavailable, or Error.
void draw_frames(const Job& job);

}  // namespace lumaknot::gpu
