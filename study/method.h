/// A way of drawing a scene: what speed is traded against accuracy with.
#pragma once

#include <memory>
#include <string>

#include "render/filter.h"
#include "scene/image.h"
#include "scene/scene.h"

namespace lumaknot {

/// How the lit colour is computed.
enum class Formula {
  kMatrices,   ///< eq. 6-8 by the space's conversions; in space rgb eq. 3
  kCollapsed,  ///< F = T + (Y_F - Y_T): linear spaces
  kBaked,      ///< the texture holds the space's axes: linear spaces
  kTable1,     ///< the paper's listing: matrices, clamps, -0.1, the normal as interpolated
};

/// What light and colour are computed in.
enum class Number { kHalf, kFloat, kDouble };

/// Half is computed by software (shaders/half.h), so that its time says nothing of hardware.
struct Method {
  int segments = 0, sides = 0;  ///< of the knot's grid; 0: the mesh as the scene has it
  Rate rate = Rate::kPixel;
  Space space = Space::kRgb;
  Formula formula = Formula::kMatrices;
  Number number = Number::kFloat;
  Filter filter = Filter::kTrilinear;
  /// A pixel. Float: of coverage and depth, shaded once a triangle; others: shaded.
  int samples = 1;
  bool culls = false;  ///< leaves out triangles that are seen from behind: float

  friend bool operator==(const Method&, const Method&) = default;
};

/// "192x10 pixel yiq-collapsed float trilinear 4x culled": the same for the same method, and for no
/// other.
std::string method_name(const Method& method);

/// Why the method can't be drawn; empty when it can. Float has 1, 2, 4, 6, 8 or 16 samples, half
/// and double squares of them, no mipmaps, and no culling.
std::string method_shortfall(const Method& method);

/// The material that `method` draws a scene of `material` with. Its numbers stay.
Material method_material(const Method& method, const Material& material);

/// What all methods of a space approximate: `material` there, at every point, with a unit normal.
Material true_material(const Material& material, Space space);

/// `mesh` with the method's grid, when it is a knot and the method has one.
MeshSpec method_mesh(const Method& method, const MeshSpec& mesh);

/// A method ready to draw a scene again and again.
class MethodRenderer {
 public:
  /// `scene` has the method's mesh; its material and samples are replaced. Draws on so many
  /// threads, 0: one for each core. Throws Error for what method_shortfall() tells, and as
  /// FastRenderer does.
  MethodRenderer(const Method& method, Scene scene, int threads = 0);
  ~MethodRenderer();

  /// One frame, as it is timed: float into 8 bits a channel.
  void draw();

  /// The frame unrounded.
  Image image();

 private:
  class Frames;
  std::unique_ptr<Frames> frames_;
};

}  // namespace lumaknot
