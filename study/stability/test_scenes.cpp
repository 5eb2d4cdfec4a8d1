#include "study/stability/test_scenes.h"

#include <algorithm>
#include <limits>

#include "math/angle.h"
#include "meshgen/knot_mesh.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "system/known.h"

namespace lumaknot::stability {

KnotSpec sketch_knot() {
  KnotSpec knot = std::get<KnotSpec>(known(builtin_scene("figure1-front")).mesh);
  knot.segments = 384;
  knot.sides = 32;
  return knot;
}

Scene knot_scene(const KnotSpec& knot, const Material& material) {
  static const TextureImage kBricks = bricks();
  Scene scene{knot_mesh(knot), kBricks, known(builtin_scene("figure1-front")).view};
  scene.view.material = material;
  return scene;
}

Material formula(std::string_view name) { return known(with_formula(Material{}, name)); }

namespace {

Scene sized(Scene scene, int side) {
  scene.view.image.width = scene.view.image.height = side;
  return scene;
}

}  // namespace

Image draw(Scene scene, int side) { return render(sized(std::move(scene), side)); }

Image shade_each(Scene scene, int side, const FragmentColor& color) {
  const Grid<Fragment> seen = visible_fragments(sized(std::move(scene), side));
  Image image(side, side);
  for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
    if (seen.pixels[i].covered()) image.pixels[i] = {to_rgb(color(seen.pixels[i])), 1};
  }
  return image;
}

double share_of(Scene scene, int side, const std::function<bool(const Fragment&)>& answer) {
  const Grid<Fragment> seen = visible_fragments(sized(std::move(scene), side));
  double covered = 0, count = 0;
  for (const Fragment& fragment : seen.pixels) {
    covered += fragment.covered();
    count += fragment.covered() && answer(fragment);
  }
  return covered > 0 ? count / covered : 0;
}

double rms_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Vec3d d = to_vec(a.pixels[i].color) - to_vec(b.pixels[i].color);
    sum += dot(d, d);
  }
  return std::sqrt(sum / (3 * double(a.pixels.size())));
}

double largest_difference(const Scene& scene, int side, const FragmentColor& a,
                          const FragmentColor& b) {
  double largest = 0;
  const Grid<Fragment> seen = visible_fragments(sized(scene, side));
  for (const Fragment& fragment : seen.pixels) {
    if (!fragment.covered()) continue;
    const Vec3d d = a(fragment) - b(fragment);
    if (!is_finite(d)) return std::numeric_limits<double>::quiet_NaN();
    largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  return largest;
}

TriangleMesh tube_of(const std::vector<RingFrame>& frames, double tube_radius, int sides) {
  TriangleMesh mesh;
  const int rings = int(frames.size()), columns = sides + 1;
  mesh.positions.resize(std::size_t(rings) * std::size_t(columns));
  mesh.normals.resize(mesh.positions.size());
  mesh.uvs.resize(mesh.positions.size());
  mesh.triangles.resize(2 * std::size_t(rings - 1) * std::size_t(sides));
  const KnotSpec tiles = sketch_knot();
  for (int i = 0; i < rings; ++i) {
    const RingFrame& frame = frames[std::size_t(i)];
    for (int j = 0; j < columns; ++j) {
      const double theta = kTurn * j / sides;
      const Vec3d out = frame.normal * std::cos(theta) + frame.binormal * std::sin(theta);
      const std::size_t at = std::size_t(i) * std::size_t(columns) + std::size_t(j);
      mesh.positions[at] = frame.position + out * tube_radius;
      mesh.normals[at] = out;
      mesh.uvs[at] = {double(tiles.repeat_u) * i / (rings - 1), double(j) / sides};
      if (i == rings - 1 || j == sides) continue;
      const std::uint32_t a = std::uint32_t(at), b = a + std::uint32_t(columns);
      const std::size_t quad = std::size_t(i) * std::size_t(sides) + std::size_t(j);
      mesh.triangles[2 * quad] = {a, b, b + 1};
      mesh.triangles[2 * quad + 1] = {a, b + 1, a + 1};
    }
  }
  return mesh;
}

}  // namespace lumaknot::stability
