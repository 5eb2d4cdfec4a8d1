/// Frames of a scene at the machine's speed: a visibility buffer, then shading in SIMD packets.
#pragma once

#include <cstdint>
#include <memory>

#include "render/filter.h"
#include "scene/image.h"
#include "scene/scene.h"

namespace lumaknot {

/// A pixel as displays have it: encoded r'g'b' and coverage, each limited to [0, 1], times 255.
struct Rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 0;
  friend constexpr bool operator==(const Rgba8&, const Rgba8&) = default;
};

/// Image points are snapped to this part of a pixel, so that edges are exact in whole numbers.
inline constexpr int kSubpixels = 1024;

/// The instructions that packets are drawn with: what every processor of the kind has (on x86-64
/// SSE2), or more.
enum class SimdLevel { kBaseline, kAvx2, kAvx512 };

/// The most that this processor has.
SimdLevel best_simd_level();

struct FastOptions {
  int samples = 1;  ///< of coverage and depth a pixel, shaded once a triangle: 1, 2, 4, 6, 8 or 16
  bool cull_back_faces = false;  ///< drops triangles that are seen clockwise
  Filter filter = Filter::kBilinear;
  Wrapping wrapping = Wrapping::kRepeat;
  int threads = 0;  ///< 0: one for each core
  SimdLevel level = best_simd_level();
};

/// A scene prepared for drawing many frames. Mesh and texture are copied; threads stay until the
/// end; after the first frame nothing is allocated. The same bytes whatever the number of threads.
class FastRenderer {
 public:
  /// Throws Error for samples that there are not, images and textures beyond 16384 pixels a side,
  /// meshes of more than 2^28 triangles or vertices, and more than one of the scene's own samples.
  FastRenderer(const Scene& scene, const FastOptions& options);
  ~FastRenderer();

  /// Draws into `image`, which gets the scene's size.
  void draw(Grid<Rgba8>& image);
  void draw(Image& image);

 private:
  class Frame;
  std::unique_ptr<Frame> frame_;
};

}  // namespace lumaknot
