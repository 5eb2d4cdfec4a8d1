/// The flags --noise, --seed and --denoise: a renderer's own random samples.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "scene/spec.h"
#include "validate/renderers/entry.h"

namespace lumaknot::cli {

/// Their values.
struct NoiseFlags {
  validate::Sampling sampling{.samples = 0, .seed = 0};
  bool given() const { return sampling.samples > 0; }
};

std::vector<Argument> noise_arguments(NoiseFlags& flags);

/// " --noise 64 --seed 2", to repeat the command; empty if they are not given.
std::string repeated(const NoiseFlags& flags);

/// The one renderer to draw with random samples: the one named, or the first that can. Throws Error
/// if several are named, or one that can't.
const validate::RendererEntry& sampling_renderer(const std::vector<std::string>& named);

/// Throws Error for more pixels than can be tested.
void check_noisy_pixels(const ImageSpec& image);

}  // namespace lumaknot::cli
