/// The claims of sections 1 and 2 about the formulas: eq. 1 to 8 and the matrices.
#pragma once

#include <span>
#include <vector>

#include "scene/image.h"
#include "shaders/spaces/matrix3.h"
#include "study/paper/as_printed.h"
#include "study/paper/claim.h"
#include "study/paper/scenes.h"

namespace lumaknot::paper {

/// Eq. 4 and 5.
struct YiqMatrices {
  Matrix3 from_rgb, to_rgb;
};
YiqMatrices paper_matrices();

PaperClaim ranges_claim(const YiqMatrices& m);
PaperClaim inverse_claim(const YiqMatrices& m);
PaperClaim ones_claim(const YiqMatrices& m);
PaperClaim luma_claim(const Vec3d& weights);

/// A point of the surface with Table 1's terms there.
struct LitPoint {
  PrintedDirections directions;
  double diffuse = 0, specular = 0;  ///< L_D, L_S
};

PaperClaim eq1_claim(std::span<const LitPoint> points);
PaperClaim delimited_claim(std::span<const LitPoint> points);
PaperClaim eq2_claim(std::span<const LitPoint> points, double shininess);

/// Pictures without highlights against the texture.
PaperClaim rgb_brightness_claim(const Image& texture, const Image& phong);
PaperClaim yiq_brightness_claim(const Image& texture, const Image& phong, const Image& yiq);

PaperClaim kept_color_claim(const Image& texture, const Image& yiq);

/// Pictures with and without the highlight.
struct HighlightPictures {
  Image with, without;
};
PaperClaim grey_added_claim(const HighlightPictures& phong);
PaperClaim highlight_depends_claim(const HighlightPictures& yiq);

PaperClaim eliminated_claim(const HighlightPictures& phong, const HighlightPictures& yiq);

/// One view with two textures.
PaperClaim always_depends_claim(const Image& one, const Image& other);

std::vector<PaperClaim> formula_claims(const PaperScenes& scenes);

}  // namespace lumaknot::paper
