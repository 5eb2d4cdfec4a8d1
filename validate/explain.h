/// Why a pixel differs: each class is a known difference, recomputed and found to explain it.
#pragma once

#include <array>
#include <string_view>

#include "render/render.h"

namespace lumaknot {

enum class PixelClass {
  kTurnedNormal,    ///< agrees once our normal, which faces away, is turned to the viewer
  kGatedHighlight,  ///< agrees once our highlight is left out where n.l <= 0
  kTexelEdge,       ///< lies among our colours within 1/100 texel
  kSilhouette,      ///< the surface ends here, or another part of it begins
  kUnexplained
};
inline constexpr std::array<std::string_view, 5> kPixelClassNames{
    "turned normal", "gated highlight", "texel edge", "silhouette", "unexplained"};

/// The fragments at whose side the surface ends or another sheet of it begins: some neighbour of
/// the eight is empty, or lies off this fragment's tangent plane, and this one off the neighbour's,
/// by more than two pixels' width.
Grid<char> silhouettes(const Scene& scene, const Grid<Fragment>& fragments);

/// The largest difference of the three channels; with `limited`, after limiting `ours` to [0, 1].
double channel_error(const Vec3d& ours, const Rgb& theirs, bool limited);

/// The first class that brings our colour at `fragment` within `tolerance` of `theirs`.
PixelClass explain(const Scene& scene, const Shot& shot, const Fragment& fragment,
                   bool at_silhouette, const Rgb& theirs, double tolerance, bool limited);

}  // namespace lumaknot
