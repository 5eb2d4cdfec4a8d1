/// Another number of tiles, or tiles that are moved.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> texture_tiles(const Situation& situation) {
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
  for (const double u : {0.5, 1.0, 2.0}) {
    for (const double v : {0.5, 1.0, 2.0}) repeat.starts.push_back({u, v});
  }
  for (const double both : {0.25, 1.0 / 3, 3.0, 4.0}) repeat.starts.push_back({both, both});
  for (const double one : {0.25, 1.0 / 3, 3.0, 4.0}) {
    repeat.starts.push_back({one, 1});
    repeat.starts.push_back({1, one});
  }
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
  for (int u = 0; u < 8; ++u) {
    for (int v = 0; v < 8; ++v)
      offset.starts.push_back(
          {u / 8.0 > 0.5 ? u / 8.0 - 1 : u / 8.0, v / 8.0 > 0.5 ? v / 8.0 - 1 : v / 8.0});
  }
  return {repeat, offset};
}

}  // namespace lumaknot::diagnosis
