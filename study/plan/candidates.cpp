#include "study/plan/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include "meshgen/knot_mesh.h"
#include "meshgen/lean_grid.h"
#include "system/error.h"

namespace lumaknot::plan {
namespace {

constexpr double kMaxTriangles = 2e6;

double triangles_of(const measure::GridSize& grid, std::size_t components) {
  return 2.0 * grid.segments * grid.sides * double(components);
}

/// The smallest grid within a pixel's shift, whose proportion all share; the scene's own if the
/// tube is too thick for one.
measure::GridSize lean_size(const KnotSpec& knot, const Predictor& predictor) {
  try {
    const Spine spine(centre_lines(knot).front());
    const double shift = std::clamp(predictor.tolerance().shift, 0.05, 1.0) * predictor.pixel();
    const LeanGrid simplified =
        lean_grid(TubeSurface(spine, knot.tube_radius), std::max(shift, 1e-3 * knot.tube_radius));
    return {simplified.segments, simplified.sides};
  } catch (const Error&) {
    return {knot.segments, knot.sides};
  }
}

bool is_fine_enough(const measure::GridSize& grid, const KnotSpec& knot,
                    const Predictor& predictor) {
  const Tolerance& tolerance = predictor.tolerance();
  const double shift = tolerance.in_place > 0 ? 0.05 : std::max(tolerance.shift, 0.05);
  const bool fine = predictor.of(measure::with_grid({}, grid)).place <= shift / 8;
  return fine && triangles_of(grid, 1) >= 4 * triangles_of({knot.segments, knot.sides}, 1);
}

/// The numbers of samples per pixel that a number type supports.
std::vector<int> samples_of(measure::Number number, bool area) {
  if (!area) return {1};
  if (number == measure::Number::kFloat) return {2, 4, 8, 16};
  return {4, 16, 64};
}

}  // namespace

std::vector<measure::GridSize> grid_ladder(const KnotSpec& knot, const Predictor& predictor) {
  constexpr double kRatio = 1.189207115002721;  // the fourth root of 2, in each direction
  const std::size_t components = centre_lines(knot).size();
  const measure::GridSize simplified = lean_size(knot, predictor);
  const double start = 3.0 / simplified.sides;
  std::vector<measure::GridSize> ladder{{knot.segments, knot.sides}};
  for (double factor = start;; factor *= kRatio) {
    const measure::GridSize grid{std::max(3, int(std::lround(simplified.segments * factor))),
                                 std::max(3, int(std::lround(simplified.sides * factor)))};
    if (triangles_of(grid, components) > kMaxTriangles) break;
    if (std::ranges::find(ladder, grid) == ladder.end()) ladder.push_back(grid);
    if (is_fine_enough(grid, knot, predictor)) break;
  }
  std::ranges::stable_sort(ladder, {},
                           [](const measure::GridSize& g) { return triangles_of(g, 1); });
  return ladder;
}

bool shows_fronts_alone(std::span<const Fragment> seen, const Vec3d& eye) {
  return std::ranges::all_of(
      seen, [&](const Fragment& f) { return dot(f.normal, eye - f.position) >= 0; });
}

std::vector<measure::Method> methods_to_draw(const Material& material, const Texture& texture,
                                             bool area, bool fronts_alone) {
  const bool textured = std::holds_alternative<TextureImage>(texture);
  std::vector<measure::Method> methods;
  for (const measure::Number number : {measure::Number::kFloat, measure::Number::kDouble}) {
    for (const int samples : samples_of(number, area)) {
      for (const ShadingFrequency rate : {ShadingFrequency::kVertex, ShadingFrequency::kPixel}) {
        for (const measure::Formula formula :
             {measure::Formula::kMatrices, measure::Formula::kCollapsed,
              measure::Formula::kBaked}) {
          for (const Filter filter : {Filter::kBilinear, Filter::kTrilinear}) {
            const bool culls = fronts_alone && number == measure::Number::kFloat;
            const measure::Method method{0,      0,      rate,    material.space, formula,
                                         number, filter, samples, culls};
            const bool shows = textured || filter == Filter::kBilinear;
            if (shows && measure::method_shortfall(method).empty()) methods.push_back(method);
          }
        }
      }
    }
  }
  return methods;
}

}  // namespace lumaknot::plan
