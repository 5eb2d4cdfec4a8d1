#include "diagnosis/target.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "shaders/graph/half.h"

namespace lumaknot::diagnosis {
namespace {

template <class F>
bool all_values(const Image& picture, F holds) {
  return std::ranges::all_of(picture.pixels, [&](const RgbaPixel& p) {
    return holds(p.color.r) && holds(p.color.g) && holds(p.color.b);
  });
}

/// Multiples of 1 / steps in [0, 1].
bool is_integer(const Image& picture, double steps, double tolerance) {
  return all_values(picture, [&](double v) {
    return v >= 0 && v <= 1 && std::abs(v * steps - std::round(v * steps)) < tolerance;
  });
}

Depth depth_of(const Image& picture) {
  if (is_integer(picture, 255, 2e-3)) return Depth::kEightBits;
  if (is_integer(picture, 65535, 2e-2)) return Depth::kSixteenBits;
  const bool half = all_values(picture, [](float v) { return double(Half(v).value) == v; });
  return half ? Depth::kHalf : Depth::kFloat;
}

/// The most frequent colour of the picture's border.
Vec3d background_of(const Image& picture) {
  std::map<std::array<float, 3>, int> counts;
  const auto count = [&](int x, int y) {
    const Rgb& c = picture.at(x, y).color;
    ++counts[{c.r, c.g, c.b}];
  };
  for (int x = 0; x < picture.width; ++x) count(x, 0), count(x, picture.height - 1);
  for (int y = 0; y < picture.height; ++y) count(0, y), count(picture.width - 1, y);
  const auto most = std::ranges::max_element(counts, {}, [](const auto& c) { return c.second; });
  return {most->first[0], most->first[1], most->first[2]};
}

double noise_of(Depth depth) {
  return depth == Depth::kEightBits ? 1.2e-3 : 2e-4;  // a step of 1/255 rounded: 1.1e-3 rms
}

}  // namespace

Facts facts_of(const Image& picture, bool limited) {
  Facts facts;
  facts.depth = depth_of(picture);
  facts.noise = noise_of(facts.depth);
  facts.limited = limited || facts.depth == Depth::kEightBits || facts.depth == Depth::kSixteenBits;
  const auto [low, high] = std::ranges::minmax(picture.pixels, {}, &RgbaPixel::coverage);
  facts.has_alpha = low.coverage != high.coverage;
  facts.alpha = low.coverage;
  if (!facts.has_alpha) facts.background = background_of(picture);
  const auto soft = std::ranges::count_if(
      picture.pixels, [](const RgbaPixel& p) { return p.coverage > 0.02f && p.coverage < 0.98f; });
  facts.soft_edges = facts.has_alpha && soft > 0;
  return facts;
}

Target target_of(const Image& picture, bool limited, long long max_pixels) {
  Target target{
      pixel_grid(picture.width, picture.height, max_pixels), facts_of(picture, limited), {}, {}};
  const Facts& facts = target.facts;
  for (std::size_t i = 0; i < target.grid.size(); ++i) {
    const RgbaPixel& p = picture.at(target.grid.x(i), target.grid.y(i));
    const Vec3d color = to_vec(p.color);
    target.colors.push_back(color);
    const bool shown = largest_magnitude(color - facts.background) > 2 * facts.noise;
    target.coverage.push_back(facts.has_alpha ? double(p.coverage) : (shown ? 1.0 : 0.0));
  }
  return target;
}

void show_like(const Target& target, Drawn& ours) {
  const Facts& facts = target.facts;
  for (std::size_t i = 0; i < ours.colors.size(); ++i) {
    Vec3d& c = ours.colors[i];
    c = c + facts.background * (1 - ours.coverage[i]);
    if (!facts.limited) continue;
    c = {std::clamp(c.x, 0.0, 1.0), std::clamp(c.y, 0.0, 1.0), std::clamp(c.z, 0.0, 1.0)};
  }
}

}  // namespace lumaknot::diagnosis
