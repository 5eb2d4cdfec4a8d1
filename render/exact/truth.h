/// The picture a knot's scene should give: rays against the exact tube, shaded in double.
#pragma once

#include "render/exact/tube.h"
#include "render/reference.h"

namespace lumaknot::exact {

/// How a pixel of the truth is computed.
enum class TruthSampling {
  kPoint,  ///< the colour at its centre, the texture bilinear between texels
  kArea,   ///< the mean over its square (box filter), texture included
};

struct TruthOptions {
  TruthSampling sampling = TruthSampling::kPoint;
  double tolerance =
      1.0 / 1024;  ///< kArea only: a pixel is divided until its estimated error is less
};

/// A picture and its uncertainty.
struct Truth {
  Image image;
  /// Per pixel. With kArea: the largest estimated error of its channels, coverage included. With
  /// kPoint: 1 where the ray touches the tube within rounding, else 0.
  Grid<float> error;
};

/// The fragment at every pixel's centre of `knot`, the scene's exact surface; the scene's mesh and
/// samples are not read. On all cores. Throws Error as ExactTube does.
Grid<ExactFragment> exact_fragments(const Scene& scene, const KnotSpec& knot);

/// `material` with light computed at every point: per-vertex light has no meaning on the tube.
Material exact_material(const Material& material);

/// The scene on the exact surface of `knot`; the scene's mesh and samples are not read. On all
/// cores; the same bytes whatever their number. Throws Error as ExactTube does.
Truth draw_truth(const Scene& scene, const KnotSpec& knot, const TruthOptions& options = {},
                 const Progress& progress = {});

/// The image of draw_truth() alone.
Image render_truth(const Scene& scene, const KnotSpec& knot, const TruthOptions& options = {},
                   const Progress& progress = {});

}  // namespace lumaknot::exact
