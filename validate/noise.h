/// The job with a renderer that samples at random: drawn as its users draw, judged by statistics.
#pragma once

#include <functional>
#include <string>

#include "validate/renderers/entry.h"
#include "validate/run.h"

namespace lumaknot::validate {

/// The chance that a renderer without any bias is found to differ, in all of its pictures together.
inline constexpr double kFamilyError = 1e-3;

/// Draws the job's shots twice with a renderer that samples, with `sampling.samples` per pixel and
/// the seeds `sampling.seed` and the next one, and tests them (compare/noise.h) against our
/// pictures through the same filter, from 8 times as many samples, at most 8,192. With
/// `sampling.denoised` they are also drawn denoised, for DenoisedErrors. The job's renderers,
/// limits and allowances do not count; its image.samples must be 1. `on_message` as for validate().
/// Throws Interrupted, and Error if there is nothing to see or no denoiser.
Validation validate_noise(const ValidationJob& job, const RendererEntry& renderer,
                          const Sampling& sampling,
                          const std::function<void(const std::string&)>& on_message = {});

}  // namespace lumaknot::validate
