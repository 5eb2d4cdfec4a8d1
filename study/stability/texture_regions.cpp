// Texture coordinates.
#include <algorithm>

#include "study/stability/regions.h"
#include "study/stability/test_scenes.h"

namespace lumaknot::stability {
namespace {

KnotSpec square_grid(double sides) {
  KnotSpec knot = sketch_knot();
  knot.sides = int(sides);
  knot.segments = 6 * int(sides);
  return knot;
}

/// The knot with one vertex where the texture begins and ends, in both directions.
Scene shared_seam(double sides) {
  const KnotSpec knot = square_grid(sides);
  Scene scene = knot_scene(knot, Material{});
  const std::uint32_t columns = std::uint32_t(knot.sides) + 1;
  for (Triangle& triangle : scene.mesh.triangles) {
    for (std::uint32_t& vertex : triangle) {
      const std::uint32_t ring = vertex / columns % std::uint32_t(knot.segments);
      vertex = ring * columns + vertex % columns % std::uint32_t(knot.sides);
    }
  }
  return scene;
}

/// The share of pixels in triangles that hold most of the texture.
double squeezed(const Scene& scene) {
  const KnotSpec knot = sketch_knot();
  return share_of(scene, 96, [&](const Fragment& f) {
    const Triangle& t = scene.mesh.triangles[std::size_t(f.triangle)];
    const auto [u0, u1] =
        std::minmax({scene.mesh.uvs[t[0]].u, scene.mesh.uvs[t[1]].u, scene.mesh.uvs[t[2]].u});
    const auto [v0, v1] =
        std::minmax({scene.mesh.uvs[t[0]].v, scene.mesh.uvs[t[1]].v, scene.mesh.uvs[t[2]].v});
    return u1 - u0 > 0.5 * knot.repeat_u || v1 - v0 > 0.5;
  });
}

Region texture_seam() {
  const auto apart = [](double sides) { return knot_scene(square_grid(sides), Material{}); };
  Region region;
  region.name = "texture-seam";
  region.group = "Textures";
  region.method = "one vertex where the texture begins and ends";
  region.reason =
      "the last strip runs from (n - 1) / n back to 0 and shows nearly the whole texture, "
      "mirrored; its share of the surface is 1 / sides + 1 / segments";
  region.remedy = "the seam's vertices twice, with both coordinates, as our meshes have them";
  region.sweep = {"sides (six times as many segments)", 128, 4, true, true};
  region.measured = "share of pixels in squeezed triangles";
  region.limit = 0.03;
  region.error = [](double n) { return squeezed(shared_seam(n)); };
  region.guarded = [apart](double n) { return squeezed(apart(n)); };
  region.sketch = [](double n, int side) { return draw(shared_seam(n), side); };
  region.guarded_sketch = [apart](double n, int side) { return draw(apart(n), side); };
  region.shown_holds = 128;
  region.shown_fails = 8;
  return region;
}

constexpr double kTexels = 512;  // of the bricks, per side

/// Texture coordinate u plus whole tiles, in float.
double scrolled(double u, double tiles) { return double(float(u) + float(tiles)); }

double scrolling_error(double tiles) {
  double largest = 0;
  for (int i = 0; i < 1000; ++i) {
    const double u = double(float(i / 1000.0));
    largest = std::max(largest, std::abs(scrolled(u, tiles) - tiles - u) * kTexels);
  }
  return largest;
}

Image draw_scrolled(double tiles, int side) {
  const Scene scene = knot_scene(Material{});
  return shade_each(scene, side, [&, color = color_in<double>(scene)](Fragment f) {
    f.uv = {scrolled(f.uv.u, tiles), scrolled(f.uv.v, tiles)};
    return color(f);
  });
}

Region scrolled_texture() {
  Region region;
  region.name = "scrolled-texture-float";
  region.group = "Textures";
  region.method = "texture coordinates in float, scrolled by many tiles";
  region.reason = "from 2^15 tiles on neighbouring floats lie two texels of 512 or more apart";
  region.remedy = "take whole tiles off before the coordinates reach the shader";
  region.sweep = {"tiles", 1, 1e7, true, true};
  region.measured = "largest error of the texture coordinate, texels of 512";
  region.limit = 0.5;
  region.error = scrolling_error;
  region.guarded = [](double tiles) { return scrolling_error(tiles - std::floor(tiles)); };
  region.sketch = draw_scrolled;
  region.guarded_sketch = [](double tiles, int side) {
    return draw_scrolled(tiles - std::floor(tiles), side);
  };
  region.guarded_shows = [](double) { return "no whole tile"; };
  region.shown_fails = 1 << 19;
  region.shown_holds = 1;
  return region;
}

}  // namespace

std::vector<Region> texture_regions() { return {texture_seam(), scrolled_texture()}; }

}  // namespace lumaknot::stability
