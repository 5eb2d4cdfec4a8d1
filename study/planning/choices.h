/// What a plan chooses from.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.h"
#include "study/method.h"
#include "study/planning/prediction.h"

namespace lumaknot {

/// A grid of the knot's mesh.
struct GridSize {
  int segments = 0, sides = 0;
  friend bool operator==(const GridSize&, const GridSize&) = default;
};

/// What a search chooses from.
struct Choices {
  std::vector<GridSize> ladder;  ///< by rising number of triangles
  std::vector<Method> ways;      ///< without grids
};

/// Grids by rising number of triangles, each some 1.4 times as many as the one before: those in
/// the proportion of the fewest triangles within a distance, from three sides up, and the scene's
/// own among them. They end where the predicted shift is an eighth of what is allowed and there are
/// four times the triangles of the scene's own, at two million triangles in any case.
std::vector<GridSize> grid_ladder(const KnotSpec& knot, const Predictor& predictor);

/// All ways to draw a scene of `material` and `texture` but for the grid: light a pixel or a
/// vertex, each formula that the space has, float or double, each filter that the texture can show;
/// one sample a pixel, or with `area` two or more. Half is left out: it is software here, and its
/// time says nothing. Float culls back faces where the picture shows `fronts_alone`: they cost time
/// and draw nothing.
std::vector<Method> ways_to_draw(const Material& material, const Texture& texture, bool area,
                                 bool fronts_alone);

/// Whether no point that is seen from `eye` shows the inside of the surface.
bool shows_fronts_alone(std::span<const Fragment> seen, const Vec3d& eye);

Method with_grid(Method method, const GridSize& grid);

}  // namespace lumaknot
