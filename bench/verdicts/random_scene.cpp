#include "bench/verdicts/random_scene.h"

#include <random>

#include "math/angle.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "system/known.h"

namespace lumaknot::verdicts {
namespace {

/// Numbers by the engine alone: the library's distributions differ from one to another.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * (double(engine_() >> 11) * 0x1p-53);
  }
  int among(int low, int high) { return low + int(engine_() % std::uint64_t(high - low + 1)); }
  bool once_in(int n) { return among(1, n) == 1; }
  Vec3d direction() {
    while (true) {
      const Vec3d v{between(-1, 1), between(-1, 1), between(-1, 1)};
      if (length(v) > 0.1 && length(v) < 1) return normalize(v);
    }
  }
  Vec3d color() { return {between(0.2, 1), between(0.2, 1), between(0.2, 1)}; }

 private:
  std::mt19937_64 engine_;
};

KnotSpec knot_of(Dice& dice) {
  KnotSpec knot;
  knot.p = dice.among(1, 5);
  knot.q = dice.among(1, 5);
  knot.minor_radius = dice.between(0.3, 0.5);
  knot.tube_radius = dice.between(0.06, 0.2);
  knot.segments = dice.among(60, 400);
  knot.sides = dice.among(8, 40);
  knot.repeat_u = dice.among(1, 20);
  knot.repeat_v = dice.among(1, 3);
  return knot;
}

Texture texture_of(Dice& dice) {
  if (dice.once_in(5)) return dice.color();
  if (!dice.once_in(3)) return bricks();
  TextureImage image;
  image.width = dice.among(2, 64);
  image.height = dice.among(2, 64);
  for (int i = 0; i < image.width * image.height; ++i) image.pixels.push_back(to_rgb(dice.color()));
  return image;
}

Light light_of(Dice& dice, int lights) {
  LightColor color;
  color.intensity = dice.between(0.4, 1.2) / lights;
  if (dice.once_in(3)) color.rgb = dice.color();
  const Vec3d from = dice.direction() * dice.between(2.5, 6);
  switch (dice.among(0, 3)) {
    case 0:
      return DirectionalLight{-from, color};
    case 1: {
      const double inner = dice.between(5, 20);
      return SpotLight{from, -from, inner, inner + dice.between(3, 20), color, {}};
    }
    default:
      return PointLight{from, color, {}};
  }
}

Camera camera_of(Dice& dice) {
  Camera camera;
  Vec3d from = dice.direction();
  while (std::abs(from.z) > 0.98) from = dice.direction();
  camera.position = from * dice.between(2.6, 5);
  camera.target = dice.direction() * dice.between(0, 0.3);
  camera.fov_degrees = dice.between(25, 60);
  return camera;
}

}  // namespace

RandomScene random_scene(std::uint64_t seed) {
  Dice dice(seed);
  const KnotSpec knot = knot_of(dice);
  Scene scene{knot_mesh(knot), texture_of(dice), {}};
  View& view = scene.view;
  view.camera = camera_of(dice);
  const int lights = dice.among(1, 3);
  view.lights.clear();
  for (int i = 0; i < lights; ++i) view.lights.push_back(light_of(dice, lights));
  view.ambient = dice.between(0, 0.3);
  const std::vector<std::string> formulas = formula_names();
  view.material =
      known(with_formula({}, formulas[std::size_t(dice.among(0, int(formulas.size()) - 1))]));
  view.material.diffuse = dice.between(0.4, 1);
  view.material.specular = dice.between(0, 0.6);
  view.image = {dice.among(64, 128), dice.among(64, 128), 1};
  return {std::move(scene), knot};
}

}  // namespace lumaknot::verdicts
