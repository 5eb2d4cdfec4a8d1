#include "study/paper/scenes.h"

#include "meshgen/knot_mesh.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "system/known.h"

namespace lumaknot::paper {
namespace {

Scene with_view(const Scene& scene, std::string_view name, int side) {
  Scene result = scene;
  result.view = known(builtin_scene(name)).view;
  result.view.image = {side, side, 1};
  return result;
}

}  // namespace

PaperScenes paper_scenes(int side) {
  PaperScenes scenes;
  const SceneSpec spec = known(builtin_scene("figure1-front"));
  const Scene plain{knot_mesh(std::get<KnotSpec>(spec.mesh)), bricks(), {}};
  scenes.front = with_view(plain, "figure1-front", side);
  scenes.back = with_view(plain, "figure1-back", side);
  scenes.specular = with_view(plain, "figure1-specular", side);
  scenes.fragments = visible_fragments(scenes.front);
  return scenes;
}

Image picture(const PaperScenes& scenes, const Scene& scene, const Material& material) {
  return shade_all(scene, {"final", Stage::kFinal, material}, scenes.fragments);
}

Material formula_of(const Scene& scene, std::string_view formula) {
  return known(with_formula(scene.view.material, formula));
}

Image stage_picture(const PaperScenes& scenes, const Scene& scene, Stage stage) {
  return shade_all(scene, {"stage", stage, scene.view.material}, scenes.fragments);
}

Material transferred(const Scene& scene, const Scene& base) {
  Material material = scene.view.material;
  material.ambient_color = material.ambient_color * (scene.view.ambient / base.view.ambient);
  return material;
}

}  // namespace lumaknot::paper
