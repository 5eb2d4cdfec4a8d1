#include "validate/compare/denoised.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lumaknot::validate {
namespace {

DenoisedErrors errors_in(const NoisyPair& pair, const Image& first, const Image& second,
                         std::size_t channel) {
  double covered = 0, noisy = 0, denoised = 0, shared = 0, sum = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    const Channels &a = pair.expected.halves[0].pixels[i], &b = pair.expected.halves[1].pixels[i];
    const double ours = (a[channel] + b[channel]) / 2;
    const double p = channel_of(first.pixels[i], channel) - ours;
    const double q = channel_of(second.pixels[i], channel) - ours;
    sum += (p + q) / 2;
    if (a[kCoverageChannel] + b[kCoverageChannel] <= 0) continue;
    ++covered;
    denoised += (p * p + q * q) / 2;
    shared += p * q;
    noisy += (std::pow(channel_of(pair.first.pixels[i], channel) - ours, 2) +
              std::pow(channel_of(pair.second.pixels[i], channel) - ours, 2)) /
             2;
  }
  const auto root = [&](double total) {
    return std::sqrt(std::max(0.0, total) / std::max(covered, 1.0));
  };
  return {root(noisy), root(denoised), root(shared), sum / double(first.pixels.size())};
}

}  // namespace

DenoisedErrors denoised_errors(const NoisyPair& pair, const Image& first, const Image& second) {
  DenoisedErrors worst;
  for (std::size_t channel = 0; channel < kCoverageChannel; ++channel) {
    const DenoisedErrors errors = errors_in(pair, first, second, channel);
    if (errors.denoised >= worst.denoised) worst = errors;
  }
  return worst;
}

std::string denoised_text(const DenoisedErrors& errors) {
  return fmt::format(
      "denoised, an error of {:.2g} per pixel, {:.2g} before; {:.2g} of it is a bias",
      errors.denoised, errors.noisy, errors.bias);
}

}  // namespace lumaknot::validate
