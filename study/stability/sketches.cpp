#include "study/stability/sketches.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exporters/image/file.h"
#include "shaders/formulas/lighting.h"

namespace lumaknot::stability {
namespace {

constexpr double kAlike = 0.1;           // of full scale
constexpr int kMaxGain = 256;            // below it what float rounds shows too
constexpr double kVisible = 0.25 / 255;  // differences below it don't choose the gain
constexpr double kUnclipped = 0.9;       // of the differences that choose it

Image with_magenta(Image image) {
  for (RgbaPixel& pixel : image.pixels) {
    if (!is_finite(to_vec(pixel.color))) pixel.color = {1, 0, 1};
  }
  return image;
}

/// The absolute differences of what is displayed.
std::vector<Vec3d> differences(const Image& a, const Image& b) {
  const Image left = with_magenta(a), right = with_magenta(b);
  std::vector<Vec3d> all;
  for (std::size_t i = 0; i < left.pixels.size(); ++i) {
    const Vec3d d =
        saturate(to_vec(left.pixels[i].color)) - saturate(to_vec(right.pixels[i].color));
    all.push_back({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  return all;
}

int gain_for(const std::vector<double>& largest) {
  std::vector<double> visible;
  std::ranges::copy_if(largest, std::back_inserter(visible), [](double d) { return d > kVisible; });
  if (visible.empty()) return kMaxGain;
  const auto at = visible.begin() + std::ptrdiff_t(kUnclipped * double(visible.size() - 1));
  std::ranges::nth_element(visible, at);
  int gain = 1;
  while (gain < kMaxGain && 2 * gain * *at <= 1) gain *= 2;
  return gain;
}

}  // namespace

std::string sketch_png(const Image& image) { return display_png(with_magenta(image)); }

std::optional<SketchDifference> difference_if_alike(const Image& a, const Image& b) {
  const std::vector<Vec3d> all = differences(a, b);
  std::vector<double> largest;
  double squares = 0;
  for (const Vec3d& d : all) {
    largest.push_back(largest_magnitude(d));
    squares += largest.back() * largest.back();
  }
  if (std::sqrt(squares / double(all.size())) >= kAlike) return {};
  SketchDifference result{Image(a.width, a.height), gain_for(largest)};
  std::ranges::transform(all, result.image.pixels.begin(), [&](const Vec3d& d) {
    return RgbaPixel{to_rgb(d * double(result.gain)), 1};
  });
  return result;
}

}  // namespace lumaknot::stability
