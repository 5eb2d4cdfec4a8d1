#include "render/texture.h"

#include <algorithm>
#include <array>

namespace lumaknot {
namespace {

/// The texels covered by one texel of the next level: two, or three if the side is odd. Their
/// shares sum to one.
struct Shares {
  int first = 0;
  std::array<double, 3> weights{};
};

Shares shares_of(int i, int size, int half) {
  const int begin = i * size, end = begin + size;  // in parts of a texel, `half` to each
  Shares shares{begin / half, {}};
  for (int k = 0; k < 3; ++k) {
    const int texel = (shares.first + k) * half;
    const int covered = std::min(end, texel + half) - std::max(begin, texel);
    shares.weights[std::size_t(k)] = double(std::max(covered, 0)) / size;
  }
  return shares;
}

}  // namespace

Vec3d texture_color(const Texture& texture, const Vec2d& uv) {
  if (const auto* color = std::get_if<Vec3d>(&texture)) return *color;
  return bilinear(std::get<TextureImage>(texture), uv, [](const Vec3d& texel) { return texel; });
}

TextureImage halved(const TextureImage& image) {
  TextureImage half(std::max(1, image.width / 2), std::max(1, image.height / 2));
  for (int y = 0; y < half.height; ++y) {
    const Shares rows = shares_of(y, image.height, half.height);
    for (int x = 0; x < half.width; ++x) {
      const Shares columns = shares_of(x, image.width, half.width);
      Vec3d sum;
      for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
          const double share = rows.weights[std::size_t(j)] * columns.weights[std::size_t(i)];
          if (share > 0) sum = sum + share * to_vec(image.at(columns.first + i, rows.first + j));
        }
      }
      half.at(x, y) = to_rgb(sum);
    }
  }
  return half;
}

}  // namespace lumaknot
