/// Another number of tiles, or tiles that are moved.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

namespace {

/// Factors that are likely, and those that make another whole number of tiles of `tiles`.
std::vector<double> factors(int tiles) {
  std::vector<double> all{0.25, 1.0 / 3, 0.5,     2.0 / 3, 0.75, 0.8, 0.9, 1.1,
                          1.2,  1.25,    4.0 / 3, 1.5,     2,    2.5, 3,   4};
  for (int other = 1; other <= 3 * tiles; ++other) all.push_back(double(other) / tiles);
  return all;
}

std::vector<std::vector<double>> repeat_starts(int tiles_u, int tiles_v) {
  std::vector<std::vector<double>> starts;
  for (const double u : factors(tiles_u)) starts.push_back({u, 1});
  for (const double v : factors(tiles_v)) starts.push_back({1, v});
  for (const double both : factors(1)) starts.push_back({both, both});
  return starts;
}

}  // namespace

std::vector<Hypothesis> tiles(const Situation& situation) {
  if (!has_image(situation)) return {};
  Hypothesis repeat{.id = "texture-repeat",
                    .rung = Rung::kTexture,
                    .parameters = {{"u", 1, 0.002, 1e-3, 1e3}, {"v", 1, 0.002, 1e-3, 1e3}},
                    .apply =
                        [](Setup& s, std::span<const double> p) {
                          s.texturing.u_scale *= p[0];
                          s.texturing.v_scale *= p[1];
                        },
                    .sentence =
                        [](std::span<const double> p) {
                          return fmt::format("{} times as many tiles along u, {} along v",
                                             number(p[0]), number(p[1]));
                        }};
  repeat.starts = repeat_starts(situation.knot ? situation.knot->repeat_u : 1,
                                situation.knot ? situation.knot->repeat_v : 1);
  Hypothesis offset{.id = "texture-offset",
                    .rung = Rung::kTexture,
                    .parameters = {{"u", 0, 0.002, -4, 4}, {"v", 0, 0.002, -4, 4}},
                    .apply =
                        [](Setup& s, std::span<const double> p) {
                          s.texturing.u_offset += p[0];
                          s.texturing.v_offset += p[1];
                        },
                    .sentence =
                        [](std::span<const double> p) {
                          return fmt::format("texture coordinates moved by ({}, {})", number(p[0]),
                                             number(p[1]));
                        }};
  constexpr int kPlaces = 32;  // along each side of a tile
  for (int u = 0; u < kPlaces; ++u) {
    for (int v = 0; v < kPlaces; ++v) {
      const auto nearest = [](int i) {
        return double(i > kPlaces / 2 ? i - kPlaces : i) / kPlaces;
      };
      offset.starts.push_back({nearest(u), nearest(v)});
    }
  }
  return {repeat, offset};
}

}  // namespace lumaknot::diagnosis
