/// How long a job's frames take.
#pragma once

#include "validate/gpu/job.h"

namespace lumaknot::gpu {

/// Draws the job's frames, each timed until the driver has finished it; the image stays in the
/// driver's memory. Writes a frame of each draw more, then prints a line of JSON: renderer (as
/// GL names it), samples (as drawn), and for each of draws its name and the milliseconds of each
/// frame. Throws Unavailable, or Error.
void draw_frames(const Job& job);

}  // namespace lumaknot::gpu
