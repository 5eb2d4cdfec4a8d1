#include "render/texture.h"

#include <cmath>

namespace lumaknot {
namespace {

/// Two neighbouring texels on one axis and the weight of the second.
struct Neighbors {
  int first, second;
  double weight;
};

Neighbors neighbors(double coordinate, int size) {
  const double wrapped = coordinate - std::floor(coordinate);
  const double texel = wrapped * size - 0.5;
  const double first = std::floor(texel);
  const int index = int(first);
  return {(index + size) % size, (index + 1) % size, texel - first};
}

}  // namespace

Vec3d texture_color(const Texture& texture, const Vec2d& uv) {
  if (const auto* color = std::get_if<Vec3d>(&texture)) return *color;
  const auto& image = std::get<TextureImage>(texture);
  const Neighbors x = neighbors(uv.u, image.width), y = neighbors(1 - uv.v, image.height);
  const auto row = [&](int j) {
    const Vec3d left = to_vec(image.at(x.first, j)), right = to_vec(image.at(x.second, j));
    return left + (right - left) * x.weight;
  };
  const Vec3d above = row(y.first), below = row(y.second);
  return above + (below - above) * y.weight;
}

}  // namespace lumaknot
