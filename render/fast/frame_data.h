/// The data that the steps of a fast frame share, as plain arrays.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>
#if __has_include(<xsimd/config/xsimd_inline.hpp>)
#include <xsimd/config/xsimd_inline.hpp>  // xsimd 13's allocator uses it and includes it not
#endif
#include <xsimd/memory/xsimd_aligned_allocator.hpp>

#include "render/fast/mipmap.h"
#include "render/fast/renderer.h"
#include "render/fast/sample_pattern.h"
#include "render/projection.h"
#include "scene/shot.h"
#include "shaders/formulas/lighting.h"
#include "system/bulk.h"

namespace lumaknot::fast {

/// Tiles are square; what a thread writes for one tile fits in its second-level cache.
constexpr int kTile = 64;
/// The farthest an image point lies from the image's corner, in pixels; so differences of snapped
/// points have 30 bits, and edge functions fit into 64.
constexpr double kGuard = 1 << 18;

/// A vertex as shading reads it.
struct VertexRecord {
  float x, y, inverse_depth;  ///< this frame's image point, in pixels
  float normal[3];
  float uv[2];
};

/// A snapped image point, in 1 / kSubpixels of a pixel.
struct SnappedPoint {
  std::int32_t x, y;
  float inverse_depth;
  std::int32_t unused = 0;
};
/// The x of a point behind the near plane or outside the guard; its y is kBehind if it lies behind
/// the near plane.
constexpr std::int32_t kOutside = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kBehind = 1;

/// The tiles that a triangle touches, packed into one number: the first, and how many more to the
/// right and below.
struct TileSpan {
  static constexpr int kRight = 16, kDown = 24;  ///< bits
  std::uint32_t first, right, down;

  explicit TileSpan(std::uint32_t packed)
      : first(packed & 0xffff), right(packed >> kRight & 0xff), down(packed >> kDown) {}
};

/// A run of triangles. Its lists are in the mesh's order: drawing the runs one after the other
/// gives the same picture whichever thread built them.
struct Run {
  std::uint32_t first = 0, last = 0;      ///< triangles [first, last)
  std::vector<std::uint32_t> candidates;  ///< those that may touch a tile: the first `found`
  std::vector<std::uint32_t> tiles;       ///< their TileSpan
  std::size_t found = 0;
  std::vector<std::uint32_t>
      listed;  ///< by tile: candidates of tile i at begins[i] to begins[i + 1]
  std::vector<std::uint32_t> begins;
  std::vector<std::uint32_t> cut;  ///< triangles that clipping must cut
};

/// The replacement of a clipped triangle: triangles [first, first + count).
struct Clipped {
  std::uint32_t triangle, first, count;
};

/// One thread's working memory for a tile.
struct TileMemory {
  template <class T>
  using Aligned = std::vector<T, xsimd::aligned_allocator<T, 64>>;

  /// Block by block, one packet per sample: what it sees, as in Nearest, or kNothing. Then a packet
  /// that takes the writes beyond the tile.
  Aligned<std::int32_t> nearest;
  Aligned<float> colors;          ///< block by block, (r, g, b, coverage) x lanes
  Aligned<std::uint8_t> touched;  ///< whether a block's colours are set
};
constexpr std::int32_t kNothing = -1, kMixed = -2;

/// One frame's arrays. Vertices and triangles created by clipping follow those of the mesh.
struct FrameData {
  int width = 0, height = 0;
  int columns = 0, rows = 0;  ///< of tiles
  Options options;
  std::span<const SamplePlace> pattern;
  Projection projection{Camera{}, 1, 1};
  double near = 0;
  Shot shot;
  Lighting<double> lighting;
  Vec3d corner_ray, ray_x, ray_y;  ///< world: the ray through the image point (x, y), depth one, is
                                   ///< corner_ray + x ray_x + y ray_y

  std::size_t vertex_count = 0, triangle_count = 0;  ///< of the mesh
  Bulk<double> xs, ys, zs;                           ///< world
  Bulk<VertexRecord> records;
  Bulk<SnappedPoint> points;
  Bulk<std::array<std::uint32_t, 4>> triangles;  ///< the fourth is unused
  Bulk<std::array<float, 6>> terms;  ///< with ShadingFrequency::kVertex: L_D and L_S per vertex
  std::vector<Clipped> clipped;      ///< in ascending order of `triangle`
  std::vector<Run> runs;
  std::vector<TileMemory> memories;  ///< one per thread
  Mipmap texture;

  Grid<Rgba8>* bytes = nullptr;  ///< the picture that is drawn, or
  Image* floats = nullptr;
};

/// The first of triangles [first, last) that was clipped; empty if none was.
const Clipped* find_clipped(const FrameData& data, std::uint32_t first, std::uint32_t last);

}  // namespace lumaknot::fast
