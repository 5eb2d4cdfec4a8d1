#include <algorithm>
#include <array>
#include <cmath>

#include "study/chart/points.h"

namespace lumaknot {
namespace {

/// The knot's grid at an eighth, a quarter, a half, full size and double; a mesh file's as it is.
std::vector<GridSize> grids(const MeshSpec& mesh) {
  const auto* knot = std::get_if<KnotSpec>(&mesh);
  if (!knot) return {{}};
  std::vector<GridSize> sizes;
  for (const double factor : {0.125, 0.25, 0.5, 1.0, 2.0}) {
    const GridSize size{std::max(3, int(std::lround(knot->segments * factor))),
                        std::max(3, int(std::lround(knot->sides * factor)))};
    if (std::ranges::find(sizes, size) == sizes.end()) sizes.push_back(size);
  }
  return sizes;
}

/// The grids that rarer choices are tried on: the scene's own and the next coarser.
std::vector<GridSize> middle_grids(const MeshSpec& mesh) {
  const auto* knot = std::get_if<KnotSpec>(&mesh);
  if (!knot) return {{}};
  std::vector<GridSize> sizes = grids(mesh);
  const GridSize own{knot->segments, knot->sides};
  const auto found = std::ranges::find(sizes, own);
  const auto first = found == sizes.begin() ? found : found - 1;
  return {first, found + 1};
}

constexpr std::array kFormulas{Formula::kMatrices, Formula::kCollapsed, Formula::kBaked,
                               Formula::kTable1};

/// Adds what can be drawn and isn't there yet.
void add(const Method& method, std::vector<Method>& all) {
  const bool possible = method_shortfall(method).empty();
  if (possible && std::ranges::find(all, method) == all.end()) all.push_back(method);
}

/// The cheapest formula that is exact in a space.
Formula lean_formula(Space space) {
  return is_linear(space) ? Formula::kCollapsed : Formula::kMatrices;
}

/// On every grid: formulas, lighting per vertex, filter and antialiasing.
void add_on_each_grid(Space space, const GridSize& size, bool filters, std::vector<Method>& all) {
  for (const int samples : {1, 4}) {
    Method method = with_grid({.space = space, .samples = samples}, size);
    for (const Formula formula : kFormulas) {
      method.formula = formula;
      add(method, all);
    }
    method.formula = lean_formula(space);
    Method rarer = method;
    rarer.rate = ShadingFrequency::kVertex;
    add(rarer, all);
    rarer = method;
    rarer.filter = Filter::kBilinear;
    if (filters) add(rarer, all);
  }
}

/// More samples, and double.
void add_on_middle_grids(Space space, const GridSize& size, std::vector<Method>& all) {
  Method method = with_grid({.space = space, .formula = lean_formula(space)}, size);
  for (const int samples : {2, 8, 16}) {
    method.samples = samples;
    add(method, all);
  }
  method.formula = Formula::kMatrices;
  method.number = Number::kDouble;
  method.filter = Filter::kBilinear;
  for (const int samples : {1, 4}) {
    method.samples = samples;
    add(method, all);
  }
}

void add_halves(Space space, const GridSize& size, std::vector<Method>& all) {
  Method method = with_grid({.space = space, .number = Number::kHalf}, size);
  method.filter = Filter::kBilinear;
  for (const Formula formula : kFormulas) {
    method.formula = formula;
    add(method, all);
  }
}

}  // namespace

std::vector<Method> usual_methods(const MeshSpec& mesh, const Texture& texture,
                                  std::span<const Space> spaces) {
  const bool filters = std::holds_alternative<TextureImage>(texture);
  std::vector<Method> all;
  for (const Space space : spaces) {
    for (const GridSize& size : grids(mesh)) add_on_each_grid(space, size, filters, all);
    for (const GridSize& size : middle_grids(mesh)) add_on_middle_grids(space, size, all);
    add_halves(space, middle_grids(mesh).back(), all);
  }
  return all;
}

}  // namespace lumaknot
