#include "cli/commands/noise_flags.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/check.h"
#include "system/error.h"

namespace lumaknot::cli {
namespace {

constexpr long long kMaxNoisyPixels = 1LL << 21;  // each takes about 800 bytes

/// The flags of the renderers that sample at random.
std::vector<std::string> sampling_flags() {
  std::vector<std::string> flags;
  for (const validate::RendererEntry* entry : validate::renderer_entries()) {
    if (entry->sampling) flags.emplace_back(entry->flag);
  }
  return flags;
}

}  // namespace

std::vector<Argument> noise_arguments(NoiseFlags& flags) {
  return {
      {.names = "--noise",
       .target = &flags.sampling.samples,
       .meaning = "random samples per pixel, drawn as Cycles draws with its own filter, twice with "
                  "two seeds; judged by statistics, in place of image.samples",
       .default_text = "one sample in each pixel's centre",
       .range = Interval<double>{2, 4096},
       .excludes = {"--self-test", "--limit", "--limits", "--allow"}},
      {.names = "--seed",
       .target = &flags.sampling.seed,
       .meaning = "seed of the first picture; the second one has the next",
       .range = Interval<double>{0, 1e9},
       .needs = "--noise"},
      {.names = "--denoise",
       .target = &flags.sampling.denoised,
       .meaning = "also draw both pictures with Blender's denoiser and report what it leaves: its "
                  "bias is no noise, so the noisy ones are judged; Debian's Blender has none",
       .needs = "--noise"}};
}

std::string repeated(const NoiseFlags& flags) {
  const validate::Sampling& s = flags.sampling;
  if (!flags.given()) return {};
  return fmt::format(" --noise {}{}{}", s.samples,
                     s.seed > 0 ? fmt::format(" --seed {}", s.seed) : "",
                     s.denoised ? " --denoise" : "");
}

const validate::RendererEntry& sampling_renderer(const std::vector<std::string>& named) {
  if (named.size() > 1) {
    throw Error(fmt::format("--noise draws with one renderer, got --renderer {}; give one of: {}",
                            fmt::join(named, ","), fmt::join(sampling_flags(), ", ")));
  }
  const std::string flag = named.empty() ? sampling_flags().front() : named.front();
  for (const validate::RendererEntry* entry : validate::renderer_entries()) {
    if (entry->flag == flag && entry->sampling) return *entry;
  }
  throw Error(fmt::format("--noise: {} draws no random samples; give --renderer {}", flag,
                          fmt::join(sampling_flags(), ", or ")));
}

void check_noisy_pixels(const ImageSpec& image) {
  check_samples({image.width, image.height}, kMaxNoisyPixels);
}

}  // namespace lumaknot::cli
