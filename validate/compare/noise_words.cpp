#include "validate/compare/noise_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lumaknot::validate {
namespace {

bool is_whole(const NoiseTest& test, std::size_t scale) { return scale + 1 == test.scales.size(); }

/// Where the largest difference of a scale is.
std::string where(const NoiseTest& test, std::size_t scale) {
  const NoiseScale& s = test.scales[scale];
  if (is_whole(test, scale)) return "the whole picture";
  const long long count = s.exceeded + s.coverage_exceeded;
  const std::string what = s.block == 1 ? count == 1 ? "pixel" : "pixels"
                                        : fmt::format("block{} of {} x {} pixels",
                                                      count == 1 ? "" : "s", s.block, s.block);
  return fmt::format("{} {}, most at ({}, {})", count, what, s.worst.place.x, s.worst.place.y);
}

}  // namespace

std::string scale_name(const NoiseTest& test, std::size_t scale) {
  if (is_whole(test, scale)) return "the whole picture";
  const int block = test.scales[scale].block;
  return block == 1 ? "a pixel" : fmt::format("{} x {} pixels", block, block);
}

std::string finding_text(const NoiseTest& test, std::size_t scale) {
  const NoiseFinding& worst = test.scales[scale].worst;
  return fmt::format("{}: {} is {:.2g} {} ours, {:.2g} admitted", where(test, scale),
                     kChannelNames[worst.channel], std::abs(worst.bias),
                     worst.bias > 0 ? "above" : "below", worst.admitted);
}

std::size_t worst_scale(const NoiseTest& test) {
  const auto share = [](const NoiseScale& s) { return s.worst.share(); };
  return std::size_t(std::ranges::max_element(test.scales, {}, share) - test.scales.begin());
}

}  // namespace lumaknot::validate
