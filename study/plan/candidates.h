/// The choices of a plan.
#pragma once

#include <span>
#include <vector>

#include "scene/spec.h"
#include "study/measure/method.h"
#include "study/plan/prediction.h"

namespace lumaknot::plan {

/// The grids and methods to search.
struct Candidates {
  std::vector<measure::GridSize> ladder;  ///< by rising number of triangles
  std::vector<measure::Method> methods;   ///< without grids
};

/// Grids by rising number of triangles, each about 1.4 times as many as the one before: those in
/// the proportion of the fewest triangles within a distance, from three sides up, and the scene's
/// own among them. They end where the predicted shift is an eighth of what is allowed (of a
/// twentieth of a pixel if a share is demanded in place) and there are four times the triangles of
/// the scene's own, and at two million triangles in any case.
std::vector<measure::GridSize> grid_ladder(const KnotSpec& knot, const Predictor& predictor);

/// All methods for a scene of `material` and `texture`, without grids: lighting per pixel or per
/// vertex, each formula of the space, float or double, each filter that the texture can show; one
/// sample per pixel, or with `area` two or more. Half is left out: it is software here, and its
/// time says nothing. Float culls back faces if the picture shows `fronts_alone`: they cost time
/// and draw nothing.
std::vector<measure::Method> methods_to_draw(const Material& material, const Texture& texture,
                                             bool area, bool fronts_alone);

/// Whether no point visible from `eye` shows the inside of the surface.
bool shows_fronts_alone(std::span<const Fragment> seen, const Vec3d& eye);

}  // namespace lumaknot::plan
