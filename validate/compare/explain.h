/// Why a pixel differs: each class is a known difference, recomputed and found to explain it.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "render/reference.h"
#include "render/shading.h"
#include "render/surface_probe.h"

namespace lumaknot::validate {

enum class PixelClass {
  kTurnedNormal,    ///< agrees once our normal, which faces away, is flipped to the viewer
  kGatedHighlight,  ///< agrees once our highlight is left out where n.l <= 0
  kTexelEdge,       ///< is among our colours within 1/100 texel
  kSilhouette,      ///< is among our colours at samples moved by at most what the limits allow: the
                    ///< surface ends here, or is seen at a grazing angle
  kSlippedRay,  ///< agrees with the surface behind, and the sample is as near to a triangle's edge:
                ///< a ray tracer's ray passed between two triangles
  kUnexplained
};
inline constexpr std::array<std::string_view, 6> kPixelClassNames{
    "turned normal", "gated highlight", "texel edge", "silhouette", "slipped ray", "unexplained"};

/// The fragments next to which the surface ends or another sheet of it begins: one of the eight
/// neighbours is empty, or is off this fragment's tangent plane, and this one off the neighbour's,
/// by more than two pixels' width.
Grid<char> silhouettes(const Scene& scene, const Grid<Fragment>& fragments);

/// The largest difference of the three channels; with `limited`, after limiting both to [0, 1].
double channel_error(const Vec3d& ours, const Rgb& theirs, bool limited);

/// Whether the normal points away from the viewer.
bool faces_away(const Scene& scene, const Fragment& fragment);

/// Our side of every comparison of one scene.
struct Reference {
  const Scene& scene;
  const Grid<Fragment>& fragments;
  Grid<char> silhouettes;
  long long silhouette_length;  ///< in pixels: how many `silhouettes` marks
  bool texture_has_16_bits;     ///< its values are multiples of 1/65535, or there is none
  SurfaceProbe probe;           ///< for samples away from the pixels' centres

  Reference(const Scene& s, const Grid<Fragment>& f);
};

/// A pixel's position in the image, from the top left.
struct PixelPlace {
  int x = 0, y = 0;
};

/// Another renderer's pixel and how close it must come to ours.
struct TheirPixel {
  PixelPlace place;
  Rgb color;
  double tolerance;  ///< per channel
  double edge;       ///< pixels by which its sample may be off the centre
  bool limited;      ///< whether colours are limited to [0, 1] before comparing
};

/// How a renderer departs from our formulas.
struct Habits {
  bool turns = false;  ///< normals that face away are turned to the viewer
  bool gates = false;  ///< there is no highlight where n.l <= 0
};

/// Explains pixels of one shot; keeps the reference and the shot by reference.
class Explainer {
 public:
  Explainer(const Reference& reference, const Shot& shot);
  Explainer(const Explainer&) = delete;
  Explainer& operator=(const Explainer&) = delete;

  /// The first class that brings our colour within the tolerance of theirs.
  PixelClass explain(const TheirPixel& theirs) const;

 private:
  Vec3d drawn_with(Habits habits, Fragment fragment) const;
  bool lies_among(const std::vector<Fragment>& fragments, const TheirPixel& theirs) const;
  bool at_texel_edge(const Fragment& fragment, const TheirPixel& theirs) const;

  const Reference& reference_;
  Shot gated_shot_;
  Shading free_, gated_;
};

/// Whether an edge of the surface passes so close to the pixel's centre that a sample moved by
/// `edge` pixels is covered where the centre is not, or vice versa.
bool explains_coverage(const Reference& reference, PixelPlace place, double edge);

}  // namespace lumaknot::validate
