/// Fast frames of a scene: a visibility buffer, then shading in SIMD packets.
#pragma once

#include <cstdint>
#include <memory>

#include "render/filter.h"
#include "scene/image.h"
#include "scene/spec.h"

namespace lumaknot::fast {

/// A display pixel: encoded r'g'b' and coverage, each limited to [0, 1], times 255.
struct Rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 0;
  friend constexpr bool operator==(const Rgba8&, const Rgba8&) = default;
};

/// Image points are snapped to this part of a pixel, so that edges are exact in integers.
inline constexpr int kSubpixels = 1024;

/// The instruction set that packets are drawn with: what every processor of the architecture has
/// (SSE2 on x86-64), or more.
enum class SimdLevel { kBaseline, kAvx2, kAvx512 };

/// The highest level that this processor supports.
SimdLevel best_simd_level();

struct Options {
  int samples =
      1;  ///< of coverage and depth per pixel, shaded once per triangle: 1, 2, 4, 6, 8 or 16
  bool cull_back_faces = false;  ///< drops triangles seen clockwise
  Filter filter = Filter::kBilinear;
  Wrapping wrapping = Wrapping::kRepeat;
  int threads = 0;  ///< 0: one per core
  SimdLevel level = best_simd_level();
};

/// A scene prepared for drawing many frames. Mesh and texture are copied; threads live as long as
/// the renderer; nothing is allocated after the first frame. The same bytes whatever the number of
/// threads.
class Renderer {
 public:
  /// Throws Error for an unsupported number of samples, images and textures beyond 16384 pixels per
  /// side, meshes of more than 2^28 triangles or vertices, and scenes whose own samples are more
  /// than one.
  Renderer(const Scene& scene, const Options& options);
  ~Renderer();

  /// Draws into `image`, which is resized to the scene's size.
  void draw(Grid<Rgba8>& image);
  void draw(Image& image);

 private:
  class Frame;
  std::unique_ptr<Frame> frame_;
};

}  // namespace lumaknot::fast
