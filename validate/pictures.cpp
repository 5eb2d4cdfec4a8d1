#include "validate/pictures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "exporters/image/file.h"
#include "validate/compare/blocks.h"
#include "validate/compare/flip.h"

namespace lumaknot::validate {
namespace {

using Bytes = std::vector<std::uint8_t>;

Rgb limited_to_display(const Rgb& c) {
  return {std::clamp(c.r, 0.0f, 1.0f), std::clamp(c.g, 0.0f, 1.0f), std::clamp(c.b, 0.0f, 1.0f)};
}

/// The colours as the page shows them.
Grid<Rgb> page_colors(const Image& image, bool limited) {
  return block_means(image, page_block(image.width, image.height), [limited](const RgbaPixel& p) {
    return limited ? limited_to_display(p.color) : p.color;
  });
}

Grid<Rgb> minus(Grid<Rgb> a, const Grid<Rgb>& b) {
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    Rgb& p = a.pixels[i];
    const Rgb& q = b.pixels[i];
    p = {p.r - q.r, p.g - q.g, p.b - q.b};
  }
  return a;
}

float largest(const Grid<Rgb>& differences) {
  float max = 0;
  for (const Rgb& d : differences.pixels) {
    max = std::max({max, std::abs(d.r), std::abs(d.g), std::abs(d.b)});
  }
  return max;
}

Bytes display_bytes(const Grid<Rgb>& colors) {
  Bytes bytes;
  bytes.reserve(3 * colors.pixels.size());
  for (const Rgb& c : colors.pixels) {
    for (const float v : {c.r, c.g, c.b}) bytes.push_back(std::uint8_t(std::lround(v * 255)));
  }
  return bytes;
}

std::string grey8_png(const Grid<std::uint8_t>& grid) {
  return smallest_png(grid.width, grid.height, 1, grid.pixels);
}

/// Of a block the largest mark: no odd pixel vanishes.
std::string marks_png(const Grid<std::uint8_t>& marks) {
  return grey8_png(block_maxima(marks, page_block(marks.width, marks.height)));
}

/// The page's excess of `image`, for a display picture of `shown`.
void set_excess(const Image& image, const Grid<Rgb>& shown, std::size_t budget, OwnPicture& own) {
  const Grid<Rgb> excess = minus(page_colors(image, false), shown);
  if (double(largest(excess)) < kFinestStep) return;
  own.excess = coded_differences(excess, budget);
}

/// FLIP in 64 levels, in blocks as large as `budget` asks for.
std::string flip_png(const Grid<float>& errors, std::size_t budget) {
  constexpr float kLevels = 63;
  std::string png;
  for (int block = 1; block <= 64; block *= 2) {
    png = grey8_png(per_block<std::uint8_t>(errors, block, [](const auto& each) {
      float max = 0;
      each([&](float error) { max = std::max(max, error); });
      return std::uint8_t(std::lround(std::round(max * kLevels) / kLevels * 255));
    }));
    if (png.size() <= budget) break;
  }
  return png;
}

Image image_of(const Grid<Rgb>& colors) {
  Image image(colors.width, colors.height);
  for (std::size_t i = 0; i < colors.pixels.size(); ++i) image.pixels[i].color = colors.pixels[i];
  return image;
}

}  // namespace

int page_block(int width, int height) {
  int block = 1;
  while (1LL * width * height > kMaxPagePixels * block * block) ++block;
  return block;
}

std::size_t picture_budget(std::size_t count) {
  constexpr std::size_t kAll = 1500 << 10, kMin = 24 << 10;
  return std::max(kAll / std::max<std::size_t>(count, 1), kMin);
}

OwnPicture own_picture(const Image& image, std::size_t budget) {
  const Grid<Rgb> shown = page_colors(image, true);
  OwnPicture own;
  own.display = smallest_png(shown.width, shown.height, 3, display_bytes(shown));
  set_excess(image, shown, budget, own);
  return own;
}

OwnPicture instead_picture(const Image& requested, const Image& instead, std::size_t budget) {
  const Grid<Rgb> shown = page_colors(instead, true);
  const Bytes before = display_bytes(page_colors(requested, true));
  Bytes bytes = display_bytes(shown);
  std::ranges::transform(bytes, before, bytes.begin(),
                         [](std::uint8_t a, std::uint8_t b) { return std::uint8_t(a - b); });
  OwnPicture own;
  own.display = smallest_png(shown.width, shown.height, 3, bytes);
  set_excess(instead, shown, budget, own);
  return own;
}

std::string cover_png(const Reference& reference) {
  const Grid<Fragment>& fragments = reference.fragments;
  Grid<std::uint8_t> cover(fragments.width, fragments.height);
  for (std::size_t i = 0; i < cover.pixels.size(); ++i) {
    if (!fragments.pixels[i].covered()) continue;
    cover.pixels[i] = reference.silhouettes.pixels[i] ? 2 : 1;
  }
  return marks_png(cover);
}

Pictures pictures_of(const Compared& pair, const Grid<PixelMark>& marks, std::size_t budget) {
  Pictures pictures;
  const Grid<Rgb> difference =
      minus(page_colors(pair.theirs, pair.limited), page_colors(pair.ours, pair.limited));
  pictures.difference = coded_differences(difference, budget);
  pictures.marks = marks_png(marks);
  if (double(largest(difference)) >= kFlipFrom) {
    const Grid<float> errors =
        flip_errors_near(image_of(page_colors(pair.ours, true)),
                         image_of(page_colors(pair.theirs, true)), float(kFlipFrom));
    pictures.flip = flip_png(errors, budget);
    pictures.mean_flip = std::accumulate(errors.pixels.begin(), errors.pixels.end(), 0.0) /
                         double(errors.pixels.size());
  }
  return pictures;
}

}  // namespace lumaknot::validate
