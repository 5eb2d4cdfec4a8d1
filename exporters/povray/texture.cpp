#include "exporters/povray/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "exporters/povray/text.h"
#include "scene/fields.h"
#include "shaders/formulas/lighting.h"

namespace lumaknot::povray {
namespace {

constexpr Vec3d kWhite{1, 1, 1};

/// One member of a texture average, or the whole texture: a pigment and its highlight and emission.
struct Layer {
  std::string pigment;
  Vec3d emission{}, ambient{};
  double diffuse = 0, highlight = 0;  // weights
};

std::string plain_pigment(const Vec3d& color) {
  return fmt::format("pigment {{ {} }}", pov_color(color));
}

std::string image_map(const std::string& file) {
  return fmt::format("image_map {{ png \"{}\" gamma 1.0 interpolate 2 }}", file);
}

std::string image_pigment(const std::string& file) {
  return fmt::format("pigment {{ uv_mapping {} }}", image_map(file));
}

std::string texture_pigment(const Texture& texture, const std::string& prefix) {
  const auto* color = std::get_if<Vec3d>(&texture);
  return color ? plain_pigment(*color) : image_pigment(pov_texture_name(prefix));
}

std::string luma_pigment(const Texture& texture, Space space, const std::string& prefix) {
  const auto* color = std::get_if<Vec3d>(&texture);
  if (!color) return image_pigment(pov_luma_name(prefix, space));
  return plain_pigment(kWhite * brightness_of<double>(*color, space));
}

/// A channel of the image `Image` as a colour: channel times `color`. A function's values beyond 1
/// wrap around to 0, and an interpolated white may slightly exceed 1, so half of it is mapped.
std::string channel_pigment(const char* channel, const Vec3d& color) {
  return fmt::format("[1 function {{ Image(x, y, z).{} / 2 }} color_map {{ [0 rgb 0] [1 {}] }}]",
                     channel, pov_color(color * 2));
}

/// The texture times `tint`, channel by channel; of an image, an average of its channels.
std::string tinted_pigment(const Texture& texture, const Vec3d& tint) {
  if (const auto* color = std::get_if<Vec3d>(&texture)) {
    return plain_pigment(modulate(*color, tint));
  }
  return fmt::format(
      "pigment {{ uv_mapping average pigment_map {{\n        {}\n        {}\n        {} }} }}",
      channel_pigment("red", {3 * tint.x, 0, 0}), channel_pigment("green", {0, 3 * tint.y, 0}),
      channel_pigment("blue", {0, 0, 3 * tint.z}));
}

/// The weight of L_D in each channel, with the lights tinted for the highlights.
Vec3d diffuse_of(const Vec3d& weight, const Vec3d& tint) {
  const auto channel = [](double w, double t) { return w == 0 ? 0 : w / t; };
  return {channel(weight.x, tint.x), channel(weight.y, tint.y), channel(weight.z, tint.z)};
}

bool tints_an_image(const View& view, const Texture& texture, const Shot& shot) {
  if (shot.stage != Stage::kFinal || shot.material.space != Space::kRgb) return false;
  const Lighting<double> lighting = lighting_of<double>(view, shot.material);
  const Vec3d diffuse = diffuse_of(lighting.diffuse, drawn_highlight(view, shot).tint);
  return !is_grey(diffuse) && std::holds_alternative<TextureImage>(texture);
}

/// Eq. 3: texture times light, plus the highlight and the emitted light.
std::vector<Layer> rgb_layers(const Lighting<double>& lighting, const PovHighlight& highlight,
                              const Texture& texture, const std::string& prefix) {
  const Vec3d diffuse = diffuse_of(lighting.diffuse, highlight.tint);
  std::vector<Layer> layers{{.pigment = texture_pigment(texture, prefix),
                             .ambient = lighting.ambient,
                             .highlight = highlight.weight}};
  if (is_grey(diffuse)) {
    layers[0].diffuse = diffuse.x;
  } else {
    const double weight = largest_component(diffuse);
    layers.push_back({.pigment = tinted_pigment(texture, diffuse / weight), .diffuse = weight});
  }
  if (lighting.emissive != Vec3d{}) {
    layers.push_back({.pigment = plain_pigment(kWhite), .emission = lighting.emissive});
  }
  return layers;
}

/// F = T + Y (L_A + L_D - 1) + L_S + offset.
std::vector<Layer> luma_layers(const Lighting<double>& lighting, Space space,
                               const Texture& texture, const std::string& prefix) {
  std::vector<Layer> layers{{.pigment = texture_pigment(texture, prefix),
                             .emission = kWhite,
                             .highlight = lighting.specular.x},
                            {.pigment = luma_pigment(texture, space, prefix),
                             .emission = lighting.ambient - kWhite,
                             .diffuse = lighting.diffuse.x}};
  const Vec3d added = lighting.emissive + kWhite * lighting.luma_offset;
  if (added != Vec3d{}) layers.push_back({.pigment = plain_pigment(kWhite), .emission = added});
  return layers;
}

/// The layers whose sum is the shot's colour.
std::vector<Layer> layers_of(const View& view, const Texture& texture, const Shot& shot,
                             const std::string& prefix) {
  switch (shot.stage) {
    case Stage::kTexture:
      return {{.pigment = texture_pigment(texture, prefix), .emission = kWhite}};
    case Stage::kDiffuse:
      return {{.pigment = plain_pigment(kWhite), .diffuse = 1}};
    case Stage::kSpecular:
      return {{.pigment = plain_pigment({}), .highlight = 1}};
    case Stage::kFinal:
      break;
  }
  const Lighting<double> lighting = lighting_of<double>(view, shot.material);
  if (shot.material.space != Space::kRgb) {
    return luma_layers(lighting, shot.material.space, texture, prefix);
  }
  return rgb_layers(lighting, drawn_highlight(view, shot), texture, prefix);
}

std::string highlight_text(double weight, const Material& material) {
  if (weight == 0) return {};
  const PovTerm term = highlight_in_pov(material);
  return fmt::format(" {} {} {} {}", term.weight, weight, term.width, term.width_value);
}

/// A layer's SDL, its weights times `scale`. POV-Ray's ambient and diffuse do not default to 0.
std::string layer_text(const Layer& layer, const Material& material, double scale) {
  const std::string emission = layer.emission == Vec3d{}
                                   ? ""
                                   : fmt::format("emission {} ", pov_color(layer.emission * scale));
  return fmt::format("{} finish {{ {}ambient {} diffuse {}{} }}", layer.pigment, emission,
                     pov_color(layer.ambient * scale), layer.diffuse * scale,
                     highlight_text(layer.highlight * scale, material));
}

/// An average divides by the number of its members, so each is weighted by that number.
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

}  // namespace

PovTerm diffuse_in_pov(const Material& m) {
  return with_diffuse(m.model, m.parameters, [](auto term, auto... p) { return term.pov(p...); });
}

PovTerm highlight_in_pov(const Material& m) {
  return with_highlight(m.model, m.parameters, [](auto term, auto... p) { return term.pov(p...); });
}

std::string pov_texture_name(const std::string& prefix) { return prefix + "texture.png"; }

std::string pov_luma_name(const std::string& prefix, Space space) {
  return fmt::format("{}{}-luma.png", prefix, kSpaceNames[std::size_t(space)]);
}

std::optional<PovHighlight> pov_highlight(const View& view, const Shot& shot) {
  if (shot.stage != Stage::kFinal) return PovHighlight{};
  const Lighting<double> lighting = lighting_of<double>(view, shot.material);
  const Vec3d& s = lighting.specular;
  if (is_grey(s)) return PovHighlight{kWhite, s.x};
  const Vec3d& d = lighting.diffuse;
  if ((s.x == 0 && d.x != 0) || (s.y == 0 && d.y != 0) || (s.z == 0 && d.z != 0)) {
    return std::nullopt;
  }
  return PovHighlight{s / largest_component(s), largest_component(s)};
}

PovHighlight drawn_highlight(const View& view, const Shot& shot) {
  if (const auto highlight = pov_highlight(view, shot)) return *highlight;
  throw std::logic_error("POV-Ray can't draw this highlight");
}

PovTexture pov_texture(const View& view, const Texture& texture, const Shot& shot,
                       const std::string& prefix) {
  PovTexture result;
  result.texture = texture_text(layers_of(view, texture, shot, prefix), shot.material);
  if (tints_an_image(view, texture, shot)) {
    result.declarations = fmt::format("#declare Image = function {{ pigment {{ {} }} }};\n",
                                      image_map(pov_texture_name(prefix)));
  }
  return result;
}

}  // namespace lumaknot::povray
