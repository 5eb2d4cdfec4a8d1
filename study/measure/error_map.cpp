#include "study/measure/error_map.h"

#include <algorithm>

#include "shaders/formulas/lighting.h"

namespace lumaknot::measure {

ErrorMap colors_of(const Image& image) {
  ErrorMap map(image.width, image.height);
  std::ranges::transform(image.pixels, map.pixels.begin(),
                         [](const RgbaPixel& p) { return to_vec(p.color); });
  return map;
}

ErrorMap colors_of(const Grid<fast::Rgba8>& image) {
  ErrorMap map(image.width, image.height);
  std::ranges::transform(image.pixels, map.pixels.begin(), [](const fast::Rgba8& p) {
    return Vec3d{p.r / 255.0, p.g / 255.0, p.b / 255.0};
  });
  return map;
}

ErrorMap limited(ErrorMap map) {
  for (Vec3d& color : map.pixels) color = saturate(color);
  return map;
}

ErrorMap minus(ErrorMap a, const ErrorMap& b) {
  for (std::size_t i = 0; i < a.pixels.size(); ++i) a.pixels[i] = a.pixels[i] - b.pixels[i];
  return a;
}

}  // namespace lumaknot::measure
