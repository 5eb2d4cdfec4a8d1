#include "render/fast/mipmap.h"

#include <algorithm>
#include <cmath>

#include "render/texture.h"
#include "shaders/formulas/lighting.h"

namespace lumaknot::fast {
namespace {

std::uint32_t byte_of(float x) {
  return std::uint32_t(std::lround(std::clamp(x, 0.0f, 1.0f) * 255));
}

bool is_byte(float x) { return float(byte_of(x)) / 255 == x || float(byte_of(x) / 255.0) == x; }

bool fits_bytes(const TextureImage& image) {
  return std::ranges::all_of(
      image.pixels, [](const Rgb& c) { return is_byte(c.r) && is_byte(c.g) && is_byte(c.b); });
}

TextureImage prepared(const TextureImage& image, const Material& material) {
  TextureImage result = image;
  for (Rgb& texel : result.pixels) texel = to_rgb(texture_value(to_vec(texel), material));
  return result;
}

void append_texel(Mipmap& mipmap, const Rgb& c, bool as_bytes) {
  if (as_bytes) {
    mipmap.bytes.push_back(byte_of(c.r) | byte_of(c.g) << 8 | byte_of(c.b) << 16);
  } else {
    for (const float each : {c.r, c.g, c.b, 0.0f}) mipmap.floats.push_back(each);
  }
}

void append(Mipmap& mipmap, const TextureImage& image, Wrapping wrapping, bool as_bytes) {
  const std::size_t texels = as_bytes ? mipmap.bytes.size() : mipmap.floats.size() / 4;
  const int width = image.width, height = image.height;
  MipLevels& levels = mipmap.levels;
  const std::size_t level = levels.count++;
  levels.widths[level] = width;
  levels.heights[level] = height;
  levels.strides[level] = width + 2;
  levels.firsts[level] = int(texels) + width + 3;
  const auto wrapped = [&](int i, int size) {
    return wrapping == Wrapping::kClamp ? std::clamp(i, 0, size - 1) : (i + size) % size;
  };
  for (int y = height; y >= -1; --y) {  // from the bottom, like texture coordinates
    for (int x = -1; x <= width; ++x) {
      append_texel(mipmap, image.at(wrapped(x, width), wrapped(y, height)), as_bytes);
    }
  }
}

}  // namespace

Mipmap make_mipmap(const Texture& texture, const Material& material, Wrapping wrapping, bool all) {
  Mipmap mipmap;
  if (const auto* color = std::get_if<Vec3d>(&texture)) {
    mipmap.color = texture_value(*color, material);
    return mipmap;
  }
  TextureImage image = prepared(std::get<TextureImage>(texture), material);
  const bool as_bytes = fits_bytes(image);
  append(mipmap, image, wrapping, as_bytes);
  while (all && (image.width > 1 || image.height > 1)) {
    image = halved(image);
    append(mipmap, image, wrapping, as_bytes);
  }
  return mipmap;
}

}  // namespace lumaknot::fast
