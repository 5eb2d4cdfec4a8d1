#include "study/measure/metrics.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "study/measure/ciede2000.h"
#include "validate/compare/quantile.h"

namespace lumaknot::measure {
namespace {

Rgb limited(const Rgb& c) {
  return {std::clamp(c.r, 0.0f, 1.0f), std::clamp(c.g, 0.0f, 1.0f), std::clamp(c.b, 0.0f, 1.0f)};
}

/// The differences at the pixels that either image covers.
struct Differences {
  std::vector<double> channels, delta_e;  ///< the largest channel's; CIEDE2000
  double squares = 0;                     ///< summed over channels
};

Differences differences(const SeenImage& truth, const SeenImage& image) {
  std::vector<std::size_t> covered;
  for (std::size_t i = 0; i < truth.image.pixels.size(); ++i) {
    const bool any = truth.image.pixels[i].coverage > 0 || image.image.pixels[i].coverage > 0;
    if (any) covered.push_back(i);
  }
  Differences result{std::vector<double>(covered.size()), std::vector<double>(covered.size()), 0};
  std::vector<double> squares(covered.size());
  oneapi::tbb::parallel_for(std::size_t{0}, covered.size(), [&](std::size_t k) {
    const std::size_t i = covered[k];
    const Rgb &p = truth.image.pixels[i].color, &q = image.image.pixels[i].color;
    if (p == q) return;
    const Vec3d d = to_vec(q) - to_vec(p);
    squares[k] = dot(d, d);
    result.channels[k] = largest_magnitude(d);
    result.delta_e[k] = ciede2000(truth.colors.pixels[i], image.colors.pixels[i]);
  });
  for (const double s : squares) result.squares += s;
  return result;
}

}  // namespace

SeenImage seen(Image image) {
  for (RgbaPixel& p : image.pixels) p.color = limited(p.color);
  Grid<Lab<double>> colors(image.width, image.height);
  oneapi::tbb::parallel_for(std::size_t{0}, image.pixels.size(), [&](std::size_t i) {
    if (image.pixels[i].coverage == 0) return;  // black, as the grid was created
    colors.pixels[i] = lab_from_xyz<double>(xyz_from_rgb<double>(to_vec(image.pixels[i].color)));
  });
  validate::FlipImage flip = validate::flip_image(image);
  return {std::move(image), std::move(colors), std::move(flip)};
}

Errors errors_between(const SeenImage& truth, const SeenImage& image) {
  assert(truth.image.pixels.size() == image.image.pixels.size());
  Differences d = differences(truth, image);
  if (d.channels.empty()) return {};
  const double count = double(d.channels.size());
  Errors errors;
  errors.rmse = std::sqrt(d.squares / (3 * count));
  for (const double e : d.delta_e) errors.delta_e += e / count;
  errors.max = std::ranges::max(d.channels);
  errors.delta_e_max = std::ranges::max(d.delta_e);
  errors.p999 = validate::quantile(std::move(d.channels), 0.999);
  errors.delta_e_p999 = validate::quantile(std::move(d.delta_e), 0.999);
  errors.flip = mean_flip(truth.flip, image.flip);
  return errors;
}

}  // namespace lumaknot::measure
