#include <algorithm>
#include <array>
#include <cmath>

#include "study/chart/points.h"

namespace lumaknot::chart {
namespace {

/// The knot's grid at an eighth, a quarter, a half, full size and double; a mesh file's as it is.
std::vector<measure::GridSize> grids(const MeshSpec& mesh) {
  const auto* knot = std::get_if<KnotSpec>(&mesh);
  if (!knot) return {{}};
  std::vector<measure::GridSize> sizes;
  for (const double factor : {0.125, 0.25, 0.5, 1.0, 2.0}) {
    const measure::GridSize size{std::max(3, int(std::lround(knot->segments * factor))),
                                 std::max(3, int(std::lround(knot->sides * factor)))};
    if (std::ranges::find(sizes, size) == sizes.end()) sizes.push_back(size);
  }
  return sizes;
}

/// The grids that rarer choices are tried on: the scene's own and the next coarser.
std::vector<measure::GridSize> middle_grids(const MeshSpec& mesh) {
  const auto* knot = std::get_if<KnotSpec>(&mesh);
  if (!knot) return {{}};
  std::vector<measure::GridSize> sizes = grids(mesh);
  const measure::GridSize own{knot->segments, knot->sides};
  const auto found = std::ranges::find(sizes, own);
  const auto first = found == sizes.begin() ? found : found - 1;
  return {first, found + 1};
}

constexpr std::array kFormulas{measure::Formula::kMatrices, measure::Formula::kCollapsed,
                               measure::Formula::kBaked, measure::Formula::kTable1};

/// Adds what can be drawn and isn't there yet.
void add(const measure::Method& method, std::vector<measure::Method>& all) {
  const bool possible = measure::method_shortfall(method).empty();
  if (possible && std::ranges::find(all, method) == all.end()) all.push_back(method);
}

/// The cheapest formula that is exact in a space.
measure::Formula lean_formula(Space space) {
  return is_linear(space) ? measure::Formula::kCollapsed : measure::Formula::kMatrices;
}

/// On every grid: formulas, lighting per vertex, filter and antialiasing.
void add_on_each_grid(Space space, const measure::GridSize& size, bool filters,
                      std::vector<measure::Method>& all) {
  for (const int samples : {1, 4}) {
    measure::Method method = measure::with_grid({.space = space, .samples = samples}, size);
    for (const measure::Formula formula : kFormulas) {
      method.formula = formula;
      add(method, all);
    }
    method.formula = lean_formula(space);
    measure::Method rarer = method;
    rarer.rate = ShadingFrequency::kVertex;
    add(rarer, all);
    rarer = method;
    rarer.filter = Filter::kBilinear;
    if (filters) add(rarer, all);
  }
}

/// More samples, and double.
void add_on_middle_grids(Space space, const measure::GridSize& size,
                         std::vector<measure::Method>& all) {
  measure::Method method =
      measure::with_grid({.space = space, .formula = lean_formula(space)}, size);
  for (const int samples : {2, 8, 16}) {
    method.samples = samples;
    add(method, all);
  }
  method.formula = measure::Formula::kMatrices;
  method.number = measure::Number::kDouble;
  method.filter = Filter::kBilinear;
  for (const int samples : {1, 4}) {
    method.samples = samples;
    add(method, all);
  }
}

void add_halves(Space space, const measure::GridSize& size, std::vector<measure::Method>& all) {
  measure::Method method =
      measure::with_grid({.space = space, .number = measure::Number::kHalf}, size);
  method.filter = Filter::kBilinear;
  for (const measure::Formula formula : kFormulas) {
    method.formula = formula;
    add(method, all);
  }
}

}  // namespace

std::vector<measure::Method> usual_methods(const MeshSpec& mesh, const Texture& texture,
                                           std::span<const Space> spaces) {
  const bool filters = std::holds_alternative<TextureImage>(texture);
  std::vector<measure::Method> all;
  for (const Space space : spaces) {
    for (const measure::GridSize& size : grids(mesh)) add_on_each_grid(space, size, filters, all);
    for (const measure::GridSize& size : middle_grids(mesh)) add_on_middle_grids(space, size, all);
    add_halves(space, middle_grids(mesh).back(), all);
  }
  return all;
}

}  // namespace lumaknot::chart
