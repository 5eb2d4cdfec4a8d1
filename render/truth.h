/// The picture that a knot's scene should give: rays against the exact tube, shaded in double.
#pragma once

#include "render/exact_tube.h"
#include "render/render.h"

namespace lumaknot {

/// What a pixel of the truth is.
enum class TruthSampling {
  kPoint,  ///< the colour at its centre, the texture bilinear between texels
  kArea,   ///< the mean over its square (box filter), texture included
};

struct TruthOptions {
  TruthSampling sampling = TruthSampling::kPoint;
  double tolerance =
      1.0 / 1024;  ///< of kArea: a pixel is divided until its estimated error is less
};

/// A picture with what is not known of it.
struct Truth {
  Image image;
  /// Of each pixel: with kArea the estimated error of its largest channel, coverage included; with
  /// kPoint 1 where the ray touches the tube within rounding, else 0.
  Grid<float> error;
};

/// What every pixel's centre sees of `knot`, the scene's exact surface; the scene's mesh and
/// samples are not read. On all cores. Throws Error as ExactTube.
Grid<ExactFragment> exact_fragments(const Scene& scene, const KnotSpec& knot);

/// `material` where light is computed at every point: a light a vertex has no meaning on the tube.
Material exact_material(const Material& material);

/// The scene on the exact surface of `knot`; the scene's mesh and samples are not read. On all
/// cores; the same bytes whatever their number. Throws Error as ExactTube.
Truth draw_truth(const Scene& scene, const KnotSpec& knot, const TruthOptions& options = {},
                 const Progress& progress = {});

/// The image of draw_truth() alone.
Image render_truth(const Scene& scene, const KnotSpec& knot, const TruthOptions& options = {},
                   const Progress& progress = {});

}  // namespace lumaknot
