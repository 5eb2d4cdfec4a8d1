/// A method of drawing a scene, which trades accuracy for speed.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "render/filter.h"
#include "scene/image.h"
#include "scene/spec.h"

namespace lumaknot::measure {

/// How the lit colour is computed.
enum class Formula {
  kMatrices,   ///< eq. 6-8 by the space's conversions; in space rgb eq. 3
  kCollapsed,  ///< F = T + (Y_F - Y_T): linear spaces
  kBaked,      ///< the texture holds the space's axes: linear spaces
  kTable1,     ///< the paper's listing: matrices, clamps, -0.1, the normal as interpolated
};

/// The number type of light and colour.
enum class Number { kHalf, kFloat, kDouble };

/// "float", "bilinear".
std::string_view number_name(Number number);
std::string_view filter_name(Filter filter);

/// Half is computed in software (shaders/graph/half.h), so its time says nothing about hardware.
struct Method {
  int segments = 0, sides = 0;  ///< of the knot's grid; 0: the scene's own mesh
  ShadingFrequency rate = ShadingFrequency::kPixel;
  Space space = Space::kRgb;
  Formula formula = Formula::kMatrices;
  Number number = Number::kFloat;
  Filter filter = Filter::kTrilinear;
  /// Per pixel. Float: of coverage and depth, shaded once per triangle; others: shaded.
  int samples = 1;
  bool culls = false;  ///< omits triangles seen from behind; float only

  friend bool operator==(const Method&, const Method&) = default;
};

/// A grid of the knot's mesh.
struct GridSize {
  int segments = 0, sides = 0;
  friend bool operator==(const GridSize&, const GridSize&) = default;
};

Method with_grid(Method method, const GridSize& grid);

/// "192x10 pixel yiq-collapsed float trilinear 4x culled": one name per
/// method.
std::string method_name(const Method& method);

/// Why the method can't be drawn; empty if it can. Float has 1, 2, 4, 6, 8 or 16 samples, half
/// and double squares of them, no mipmaps, and no culling.
std::string method_shortfall(const Method& method);

/// The material that `method` draws a scene of `material` with. Its numbers are unchanged.
Material method_material(const Method& method, const Material& material);

/// What all methods of a space approximate: `material` there, per pixel, with a unit normal.
Material true_material(const Material& material, Space space);

/// `mesh` with the method's grid, if it is a knot and the method has one.
MeshSpec method_mesh(const Method& method, const MeshSpec& mesh);

/// A method ready to draw a scene repeatedly.
class MethodRenderer {
 public:
  /// `scene` has the method's mesh; its material and samples are replaced. Draws on
  /// `threads` threads, 0: one per core. Throws Error if there is a method_shortfall(), and as
  /// fast::Renderer does.
  MethodRenderer(const Method& method, Scene scene, int threads = 0);
  ~MethodRenderer();

  /// One frame, as it is timed: float into 8 bits per channel.
  void draw();

  /// The frame unrounded.
  Image image();

 private:
  class Frames;
  std::unique_ptr<Frames> frames_;
};

}  // namespace lumaknot::measure
