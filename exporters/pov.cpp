#include "exporters/pov.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "exporters/image_file.h"
#include "shaders/yiq.h"

namespace lumaknot {
namespace {

std::string vec(const Vec3d& v) { return fmt::format("<{}, {}, {}>", v.x, v.y, v.z); }

/// One member of a texture average, or the whole texture: a pigment and what shines off it.
struct Layer {
  std::string pigment;
  double emission = 0, ambient = 0, diffuse = 0, highlight = 0;  // weights
};

std::string grey(double value) { return fmt::format("pigment {{ rgb {} }}", value); }

std::string image_pigment(const std::string& file) {
  return fmt::format("pigment {{ uv_mapping image_map {{ png \"{}\" gamma 1.0 interpolate 2 }} }}",
                     file);
}

std::string texture_pigment(const Texture& texture, const PovNames& names) {
  const auto* color = std::get_if<Vec3d>(&texture);
  return color ? fmt::format("pigment {{ rgb {} }}", vec(*color)) : image_pigment(names.texture);
}

std::string luma_pigment(const Texture& texture, const PovNames& names) {
  const auto* color = std::get_if<Vec3d>(&texture);
  return color ? grey(dot(kYiqFromRgb[0], *color)) : image_pigment(names.luma);
}

/// A layer's SDL, its weights times `scale`.
std::string layer_text(const Layer& layer, const Material& material, double scale) {
  return fmt::format("{} finish {{ emission {} ambient {} diffuse {} phong {} phong_size {} }}",
                     layer.pigment, layer.emission * scale, layer.ambient * scale,
                     layer.diffuse * scale, layer.highlight * scale, material.shininess);
}

/// The layers whose sum is the shot's colour.
std::vector<Layer> layers_of(const Scene& scene, const Shot& shot, const PovNames& names) {
  const Material& m = shot.material;
  const std::string texture = texture_pigment(scene.texture, names);
  const double ambient = scene.view.ambient;
  if (shot.stage == Stage::kTexture) return {{.pigment = texture, .emission = 1}};
  if (shot.stage == Stage::kDiffuse) return {{.pigment = grey(1), .diffuse = 1}};
  if (shot.stage == Stage::kSpecular) return {{.pigment = grey(0), .highlight = 1}};
  if (m.space == Space::kRgb) {
    return {
        {.pigment = texture, .ambient = ambient, .diffuse = m.diffuse, .highlight = m.specular}};
  }
  std::vector<Layer> layers{{.pigment = texture, .emission = 1, .highlight = m.specular},
                            {.pigment = luma_pigment(scene.texture, names),
                             .emission = ambient - 1,
                             .diffuse = m.diffuse}};
  if (m.luma_offset != 0) layers.push_back({.pigment = grey(1), .emission = m.luma_offset});
  return layers;
}

/// An average divides by the number of its members, so each weighs that much more.
std::string texture_text(const std::vector<Layer>& layers, const Material& material) {
  if (layers.size() == 1) {
    return fmt::format("  texture {{ {} }}\n", layer_text(layers[0], material, 1));
  }
  std::string text = "  texture {\n    average texture_map {\n";
  for (const Layer& layer : layers) {
    text += fmt::format("      [1 {}]\n", layer_text(layer, material, double(layers.size())));
  }
  return text + "    }\n  }\n";
}

/// The field of view as the lengths of `right` and `up` beside a unit `direction`; explicit vectors
/// keep POV-Ray right-handed.
std::string camera_text(const View& view) {
  const CameraFrame frame = camera_frame(view.camera);
  const double height = 2 * std::tan(view.camera.fov_degrees * std::numbers::pi / 360);
  const double width = height * view.image.width / view.image.height;
  return fmt::format(
      "camera {{ perspective\n  location {}\n  direction {}\n  right {}\n  up {}\n}}\n",
      vec(view.camera.position), vec(-frame.back), vec(frame.right * width),
      vec(frame.up * height));
}

/// POV-Ray draws no highlight where n.l < 0, unless the object is lit from both sides; that also
/// turns the diffuse term's sign, so it serves only where there is none.
bool lit_from_both_sides(const Shot& shot) {
  return shot.stage == Stage::kSpecular ||
         (shot.stage == Stage::kFinal && shot.material.diffuse == 0);
}

Grid<float> luma_of(const TextureImage& texture) {
  Grid<float> luma(texture.width, texture.height);
  for (std::size_t i = 0; i < luma.pixels.size(); ++i) {
    luma.pixels[i] = float(dot(kYiqFromRgb[0], to_vec(texture.pixels[i])));
  }
  return luma;
}

void append_vec(std::string& text, const Vec3d& v) {
  fmt::format_to(std::back_inserter(text), "<{:.9g},{:.9g},{:.9g}>\n", float(v.x), float(v.y),
                 float(v.z));
}

}  // namespace

std::optional<std::string> pov_shortfall(const Shot& shot) {
  if (shot.stage != Stage::kFinal) return std::nullopt;
  const bool clamps = shot.material.clamp == Clamp::kTable1;
  const bool raw_normal = shot.material.normal == NormalUse::kInterpolated;
  if (!clamps && !raw_normal) return std::nullopt;
  return fmt::format("POV-Ray can't {}{}{}", clamps ? "clamp ambient plus diffuse light" : "",
                     clamps && raw_normal ? " nor " : "",
                     raw_normal ? "use an interpolated normal without renormalising it" : "");
}

std::string pov_mesh(const TriangleMesh& mesh) {
  std::string text;
  const auto begin = [&](std::string_view name, std::size_t count) {
    fmt::format_to(std::back_inserter(text), "  {} {{ {}\n", name, count);
  };
  begin("vertex_vectors", mesh.positions.size());
  for (const Vec3d& p : mesh.positions) append_vec(text, p);
  text += "  }\n";
  begin("normal_vectors", mesh.normals.size());
  for (const Vec3d& n : mesh.normals) append_vec(text, n);
  text += "  }\n";
  begin("uv_vectors", mesh.uvs.size());
  for (const Vec2d& uv : mesh.uvs) {
    fmt::format_to(std::back_inserter(text), "<{:.9g},{:.9g}>\n", float(uv.u), float(uv.v));
  }
  text += "  }\n";
  begin("face_indices", mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    fmt::format_to(std::back_inserter(text), "<{},{},{}>\n", t[0], t[1], t[2]);
  }
  return text + "  }\n";
}

std::string pov_scene(const Scene& scene, const Shot& shot, const PovNames& names,
                      std::string_view mesh) {
  std::string text =
      "#version 3.7;\n"
      "global_settings { assumed_gamma 1.0 ambient_light rgb 1 }\n"
      "background { rgbt <0, 0, 0, 1> }\n";
  text += camera_text(scene.view);
  text += fmt::format("light_source {{ {} rgb 1 }}\n", vec(scene.view.light.position));
  text += fmt::format("mesh2 {{\n{}", mesh);
  text += texture_text(layers_of(scene, shot, names), shot.material);
  text += fmt::format("  no_shadow{}\n}}\n", lit_from_both_sides(shot) ? " double_illuminate" : "");
  return text;
}

Package pov_textures(const Scene& scene, const PovNames& names) {
  const auto* texture = std::get_if<TextureImage>(&scene.texture);
  if (!texture) return {};
  return {{names.texture, texture_png(*texture)}, {names.luma, grey_png(luma_of(*texture))}};
}

Package pov_package(const Scene& scene, const std::string& name) {
  const Shot shot{"final", Stage::kFinal, scene.view.material};
  const PovNames names{name + ".texture.png", name + ".luma.png"};
  Package package = pov_textures(scene, names);
  if (shot.material.space == Space::kRgb && !package.empty()) package.pop_back();  // no luma needed
  const ImageSpec& image = scene.view.image;
  std::string text = fmt::format(
      "// Made by lumaknot. In this folder:\n"
      "//   povray +I{0}.pov +O{0}.png +W{1} +H{2} -A +UA +FN16 File_Gamma=1.0 -D\n",
      name, image.width, image.height);
  if (const auto shortfall = pov_shortfall(shot)) text += fmt::format("// {}.\n", *shortfall);
  text += pov_scene(scene, shot, names, pov_mesh(scene.mesh));
  package.push_back({name + ".pov", std::move(text)});
  return package;
}

}  // namespace lumaknot
