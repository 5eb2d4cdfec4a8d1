#include "exporters/povray/scene.h"

#include <cmath>
#include <set>
#include <sstream>

#include "exporters/image/file.h"
#include "exporters/povray/format.h"
#include "exporters/povray/lights.h"
#include "exporters/povray/text.h"
#include "exporters/povray/texture.h"
#include "math/angle.h"
#include "shaders/spaces/conversions.h"

namespace lumaknot::povray {
namespace {

/// The field of view as the lengths of `right` and `up` for a unit `direction`; explicit vectors
/// keep POV-Ray right-handed.
std::string camera_text(const View& view) {
  const CameraFrame frame = camera_frame(view.camera);
  const double height = 2 * std::tan(view.camera.fov_degrees * kPi / 360);
  const double width = height * view.image.width / view.image.height;
  return fmt::format(
      "camera {{ perspective\n  location {}\n  direction {}\n  right {}\n  up {}\n}}\n",
      pov_vector(view.camera.position), pov_vector(-frame.back), pov_vector(frame.right * width),
      pov_vector(frame.up * height));
}

/// POV-Ray draws no highlight where n.l < 0, unless the object is lit from both sides; that also
/// flips the diffuse term's sign, so it is only used where there is none.
bool lit_from_both_sides(const View& view, const Shot& shot) {
  return shot.material.highlights == Highlights::kFree && needs_specular(view, shot) &&
         !needs_diffuse(view, shot);
}

std::string lights_text(const View& view, const Shot& shot) {
  if (!needs_diffuse(view, shot) && !needs_specular(view, shot)) return {};
  const Vec3d tint =
      shot.material.space == Space::kRgb ? drawn_highlight(view, shot).tint : Vec3d{1, 1, 1};
  return pov_lights(view, shot.material.space, tint);
}

Grid<float> luma_of(const TextureImage& texture, Space space) {
  Grid<float> luma(texture.width, texture.height);
  for (std::size_t i = 0; i < luma.pixels.size(); ++i) {
    luma.pixels[i] = float(brightness_of<double>(to_vec(texture.pixels[i]), space));
  }
  return luma;
}

bool reads_luma(const Shot& shot) {
  return shot.stage == Stage::kFinal && is_linear(shot.material.space);
}

}  // namespace

std::string pov_mesh(const TriangleMesh& mesh) {
  std::ostringstream text;
  write_pov_mesh(text, mesh);
  return std::move(text).str();
}

std::string pov_scene(const View& view, const Texture& texture, const Shot& shot,
                      const std::string& prefix, std::string_view mesh) {
  const PovTexture drawn = pov_texture(view, texture, shot, prefix);
  std::string text =
      "#version 3.7;\n"
      "global_settings { assumed_gamma 1.0 ambient_light rgb 1 }\n"
      "background { rgbt <0, 0, 0, 1> }\n";
  text += camera_text(view);
  text += lights_text(view, shot);
  text += drawn.declarations;
  text += fmt::format("mesh2 {{\n{}", mesh);
  text += drawn.texture;
  text += fmt::format("  no_shadow{}\n}}\n",
                      lit_from_both_sides(view, shot) ? " double_illuminate" : "");
  return text;
}

Package pov_textures(const Texture& texture, std::span<const Shot> shots,
                     const std::string& prefix) {
  const auto* image = std::get_if<TextureImage>(&texture);
  if (!image) return {};
  Package package{{pov_texture_name(prefix), texture_png(*image)}};
  std::set<Space> spaces;
  for (const Shot& shot : shots) {
    if (reads_luma(shot)) spaces.insert(shot.material.space);
  }
  for (const Space space : spaces) {
    package.push_back({pov_luma_name(prefix, space), grey_png(luma_of(*image, space))});
  }
  return package;
}

Package pov_package(const Scene& original, const std::string& name) {
  const Placement placement = pov_placement(original.mesh);
  const Scene scene = placed(original, placement);
  const View& view = scene.view;
  const Shot shot{"final", Stage::kFinal, view.material};
  check_pov_export(view, shot);
  const std::string prefix = name + ".";
  std::string text = fmt::format(
      "// Made by lumaknot. In this folder:\n"
      "//   povray +I{0}.pov +O{0}.png +W{1} +H{2} -A +UA +FN16 File_Gamma=1.0 -D\n",
      name, view.image.width, view.image.height);
  if (placement != Placement{}) {
    text += fmt::format("// The origin is {} of the scene, lengths are {} times as large.\n",
                        pov_vector(placement.origin), placement.scale);
  }
  if (const auto shortfall = pov_shortfall(view, shot)) {
    text += fmt::format("// {}.\n", *shortfall);
  }
  text += pov_scene(view, scene.texture, shot, prefix, pov_mesh(scene.mesh));
  Package package = pov_textures(scene.texture, {&shot, 1}, prefix);
  package.push_back({name + ".pov", std::move(text)});
  return package;
}

}  // namespace lumaknot::povray
