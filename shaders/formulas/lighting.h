/// The lit colour, each formula once, over any number type. Equation numbers: Kotsarenko and Ramos,
/// "Alternative Diffuse Lighting and Specular Reflection Approach Using YIQ Color Space".
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "math/angle.h"
#include "scene/shot.h"
#include "shaders/formulas/terms.h"
#include "shaders/spaces/conversions.h"

namespace lumaknot {

/// The numbers of the lights, the view and the material, as the number type sees them. Colours are
/// grey in a space of brightness.
template <class S>
struct Lighting {
  Vec<S> eye_position;  ///< world
  std::vector<LightNumbers<S>> lights;
  ModelParameters<S> parameters;                ///< of the lighting model
  Vec<S> ambient, diffuse, specular, emissive;  ///< weights times colours
  S luma_offset;
};

/// `light` and `highlight` with the weights and, with Clamp::kTable1, the clamps.
template <class S>
struct Lit {
  Vec<S> light;      ///< L_A + L_D: times the texture
  Vec<S> highlight;  ///< L_S and what is emitted: added
};

template <class S>
Lit<S> weighted(const Terms<S>& terms, const Lighting<S>& lighting, bool clamped) {
  const Vec<S> received = clamped ? saturate(terms.diffuse) : terms.diffuse;
  const Vec<S> sum = modulate(lighting.diffuse, received) + lighting.ambient;
  const Vec<S> highlight = modulate(lighting.specular, terms.specular) + lighting.emissive;
  return {named("light", clamped ? saturate(sum) : sum), named("highlight", highlight)};
}

/// Brightness after light: Y_F = Y_T (L_A + L_D) + L_S (eq. 6), plus Table 1's offset.
template <class S>
S lit_brightness(const S& brightness, const Lit<S>& lit, const Lighting<S>& lighting) {
  return named("lit_brightness",
               brightness * x_of(lit.light) + x_of(lit.highlight) + lighting.luma_offset);
}

/// A colour and its brightness.
template <class S>
struct Relit {
  Vec<S> color;
  S brightness;
};

/// The colour that `texture` becomes when light has changed its brightness alone: eq. 6-8 in any
/// space.
template <class S>
Relit<S> relit(const Vec<S>& texture, const Lit<S>& lit, const Lighting<S>& lighting,
               const Material& m) {
  if (m.form == Form::kCollapsed) {
    const S before = named("brightness", brightness_of<S>(texture, m.space));
    const S after = lit_brightness(before, lit, lighting);
    return {texture + grey(after - before), after};
  }
  const bool baked = m.form == Form::kBaked;
  Axes<S> axes = baked ? Axes<S>{x_of(texture), y_of(texture), z_of(texture)}
                       : axes_from_rgb<S>(texture, m.space);
  axes.brightness = lit_brightness(axes.brightness, lit, lighting);
  return {rgb_from_axes(axes, m.space), axes.brightness};
}

/// Without an axis of brightness: eq. 3. Its own brightness is YIQ's luma.
template <class S>
Relit<S> relit_rgb(const Vec<S>& texture, const Lit<S>& lit) {
  const Vec<S> color = modulate(texture, lit.light) + lit.highlight;
  return {color, brightness_of<S>(color, Space::kYiq)};
}

/// The lit colour: eq. 3 in space rgb, eq. 6-8 in the others, then the clamp or the gamut's rule.
template <class S>
Vec<S> lit_color(const Vec<S>& texture, const Terms<S>& terms, const Lighting<S>& lighting,
                 const Material& m) {
  const bool table1 = m.clamp == Clamp::kTable1;
  const Lit<S> lit = weighted(terms, lighting, table1);
  const Relit<S> result =
      m.space == Space::kRgb ? relit_rgb(texture, lit) : relit(texture, lit, lighting, m);
  if (m.gamut == Gamut::kChroma) {
    const Space space = m.space == Space::kRgb ? Space::kYiq : m.space;
    return reduce_chroma(result.color, neutral_of(result.brightness, space));
  }
  return table1 || m.gamut == Gamut::kClamp ? saturate(result.color) : result.color;
}

/// What `shot` shows where the light sends `terms`; `texture` as the form of the material has it.
template <class S>
Vec<S> stage_color(const Vec<S>& texture, const Terms<S>& terms, const Lighting<S>& lighting,
                   const Shot& shot) {
  const Material& m = shot.material;
  switch (shot.stage) {
    case Stage::kDiffuse:
      return terms.diffuse;
    case Stage::kSpecular:
      return terms.specular;
    case Stage::kFinal:
      return lit_color(texture, terms, lighting, m);
    case Stage::kTexture:
      break;
  }
  if (m.form != Form::kBaked) return texture;
  return rgb_from_axes(Axes<S>{x_of(texture), y_of(texture), z_of(texture)}, m.space);
}

/// `stage_color` with the light computed at the point.
template <class S>
Vec<S> stage_color(const SurfacePoint<S>& point, const Vec<S>& texture, const Lighting<S>& lighting,
                   const Shot& shot) {
  const Terms<S> terms = surface_terms(point, lighting.eye_position, lighting.lights,
                                       lighting.parameters, shot.material);
  return stage_color(texture, terms, lighting, shot);
}

/// The texture's colour as the form of `material` reads it: baked, on the axes of its space.
inline Vec3d texture_value(const Vec3d& rgb, const Material& material) {
  if (material.form != Form::kBaked) return rgb;
  const Axes<double> axes = axes_from_rgb<double>(rgb, material.space);
  return {axes.brightness, axes.c1, axes.c2};
}

/// The brightness of a light's or weight's colour relative to white's.
inline double relative_brightness(const Vec3d& rgb, Space space) {
  return brightness_of<double>(rgb, space) / brightness_of<double>(Vec3d{1, 1, 1}, space);
}

/// Names the numbers of a scene for a number type. A source has the members
///   S number(name, value) and Vec<S> vector(name, value),
/// which give the scene's `value`, or another in its place.
template <class S, class Source>
class Numbers {
 public:
  Numbers(const Source& source, Space space) : source_(source), space_(space) {}

  S number(const std::string& name, double value) const { return source_.number(name, value); }
  Vec<S> vector(const std::string& name, const Vec3d& value) const {
    return source_.vector(name, value);
  }
  /// A weight times a colour: grey in a space of brightness.
  Vec<S> color(const std::string& name, double weight, const Vec3d& rgb) const {
    if (space_ == Space::kRgb) return source_.color(name, rgb * weight);
    return grey(number(name, weight * relative_brightness(rgb, space_)));
  }

 private:
  const Source& source_;
  Space space_;
};

/// The numbers of one light, their names beginning with `prefix`.
template <class S, class Source>
class LightReader {
 public:
  LightReader(const Numbers<S, Source>& numbers, std::string prefix)
      : numbers_(numbers), prefix_(std::move(prefix)) {}

  LightNumbers<S> operator()(const PointLight& light) const {
    LightNumbers<S> result = common(light.color);
    result.position = numbers_.vector(prefix_ + "position", light.position);
    add_falloff(result, light.falloff);
    return result;
  }
  LightNumbers<S> operator()(const DirectionalLight& light) const {
    LightNumbers<S> result = common(light.color);
    result.has_position = false;
    result.direction = numbers_.vector(prefix_ + "direction", normalize(light.direction));
    return result;
  }
  LightNumbers<S> operator()(const SpotLight& light) const {
    LightNumbers<S> result = common(light.color);
    result.position = numbers_.vector(prefix_ + "position", light.position);
    result.direction = numbers_.vector(prefix_ + "direction", normalize(light.direction));
    result.has_cone = true;
    const double cos_inner = std::cos(light.inner_degrees * kPi / 180);
    const double cos_outer = std::cos(light.outer_degrees * kPi / 180);
    result.cos_outer = numbers_.number(prefix_ + "cos_outer", cos_outer);
    result.cone_scale = numbers_.number(prefix_ + "cone_scale", 1 / (cos_inner - cos_outer));
    add_falloff(result, light.falloff);
    return result;
  }

 private:
  LightNumbers<S> common(const LightColor& color) const {
    LightNumbers<S> result;
    result.position = result.direction = constant_vec<S>({});
    result.color = numbers_.color(prefix_ + "color", color.intensity, color.rgb);
    return result;
  }
  void add_falloff(LightNumbers<S>& light, const Falloff& falloff) const {
    light.constant = numbers_.number(prefix_ + "constant", falloff.constant);
    light.linear = numbers_.number(prefix_ + "linear", falloff.linear);
    light.quadratic = numbers_.number(prefix_ + "quadratic", falloff.quadratic);
  }

  const Numbers<S, Source>& numbers_;
  std::string prefix_;
};

/// The numbers of `view` with `m` as its material, each asked of `source` under its name. With
/// several lights their names begin with light1_, light2_, ...
template <class S, class Source>
Lighting<S> lighting_of(const View& view, const Material& m, const Source& source) {
  const Numbers<S, Source> numbers(source, m.space);
  std::vector<LightNumbers<S>> lights;
  for (std::size_t i = 0; i < view.lights.size(); ++i) {
    const std::string number = view.lights.size() > 1 ? std::to_string(i + 1) : "";
    lights.push_back(
        std::visit(LightReader<S, Source>(numbers, "light" + number + "_"), view.lights[i]));
  }
  const Vec3d& s_a = view.ambient_color;
  const Vec3d& m_a = m.ambient_color;
  return {numbers.vector("eye_position", view.camera.position),
          std::move(lights),
          ModelParameters<S>::from([&](std::size_t i) {
            return numbers.number(std::string(model_parameters()[i].name), m.parameters.at(i));
          }),
          numbers.color("ambient", view.ambient, modulate(s_a, m_a)),
          numbers.color("diffuse", m.diffuse, m.diffuse_color),
          numbers.color("specular", m.specular, m.specular_color),
          numbers.color("emissive", 1, m.emissive),
          numbers.number("luma_offset", m.luma_offset)};
}

/// The scene's numbers as they are.
template <class S>
struct PlainNumbers {
  S number(const std::string&, double value) const { return S(value); }
  Vec<S> vector(const std::string&, const Vec3d& value) const { return constant_vec<S>(value); }
  Vec<S> color(const std::string&, const Vec3d& value) const { return constant_vec<S>(value); }
};

template <class S>
Lighting<S> lighting_of(const View& view, const Material& material) {
  return lighting_of<S>(view, material, PlainNumbers<S>{});
}

}  // namespace lumaknot
