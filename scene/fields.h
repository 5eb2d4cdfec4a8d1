/// Every field of a scene described once: its JSON key, its range, its meaning. The reader, the
/// writer, the published schema, the range checks and the command line's flags all visit this
/// table.
///
/// A visitor has the members
///   integer(key, int&, Interval<int>, about), number(key, double&, Interval<double>, about),
///   vector(key, Vec3d&, about), color(key, Vec3d&, about), text(key, std::string&, about),
///   constant(key, value, about), choice(key, Enum&, names, about), object(key, Struct&, about),
///   one_of(key, variant&, about), which calls visit_value() with the chosen alternative,
///   and list(key, vector<variant>&, max, about), each element as one_of.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "scene/spec.h"

namespace lumaknot {

/// For light and lit colours: single precision holds the products and sums of such numbers.
inline constexpr double kBrightest = 1e6;
inline constexpr Interval<double> kBrightness{.min = 0, .max = kBrightest};

/// The names of an enumeration's values, in order.
inline constexpr std::array<std::string_view, 8> kSpaceNames{"rgb",    "yiq",    "yuv601", "yuv709",
                                                             "cielab", "cieluv", "din99",  "atd95"};
inline constexpr std::array<std::string_view, 3> kFormNames{"matrices", "collapsed", "baked"};
inline constexpr std::array<std::string_view, 2> kClampNames{"free", "table1"};
inline constexpr std::array<std::string_view, 2> kNormalNames{"unit", "interpolated"};
inline constexpr std::array<std::string_view, 3> kGamutNames{"free", "clamp", "chroma"};
inline constexpr std::array<std::string_view, 2> kHighlightNames{"free", "gated"};
inline constexpr std::array<std::string_view, 2> kFrequencyNames{"pixel", "vertex"};

inline constexpr std::array<std::string_view, 4> kConventionNames{"lumaknot", "three", "babylon",
                                                                  "blender"};
inline constexpr std::array<std::string_view, 5> kFrameNames{
    "rotation-minimizing", "double-reflection", "frenet", "fixed-up", "three"};
inline constexpr std::array<std::string_view, 2> kUnwrapNames{"parameter", "arc-length"};

inline constexpr std::size_t kMaxLights = 16;

template <class V>
void visit_fields(V& v, KnotSpec& k) {
  v.choice("convention", k.convention, kConventionNames,
           "whose vertices, normals, texture coordinates and defaults");
  v.integer("p", k.p, {-1000, 1000}, "turns about the axis");
  v.integer("q", k.q, {-1000, 1000}, "turns through the hole; a link when not coprime to p");
  v.number("ring", k.major_radius, kPositive, "radius of the ring, axis to tube centre");
  v.number("winding", k.minor_radius, kPositive, "radius of the winding about the ring");
  v.number("tube", k.tube_radius, kPositive, "radius of the tube swept along the knot");
  v.integer("segments", k.segments, {3, 10'000'000}, "faces along each component");
  v.integer("sides", k.sides, {3, 1'000'000}, "faces around the tube");
  v.integer("repeat_u", k.repeat_u, {1, 10'000}, "texture tiles along the knot");
  v.integer("repeat_v", k.repeat_v, {1, 10'000}, "texture tiles around the tube");
  v.choice("frames", k.frames, kFrameNames, "how the rings turn about the centre line");
  v.choice("unwrap", k.unwrap, kUnwrapNames, "what texture coordinates along are proportional to");
}

template <class V>
void visit_fields(V& v, Camera& c) {
  v.vector("position", c.position, "the eye");
  v.vector("target", c.target, "what it looks at");
  v.vector("up", c.up, "upwards in the image");
  v.number("fov_degrees", c.fov_degrees, {.min = 0, .max = 180, .open_min = true, .open_max = true},
           "vertical field of view, degrees");
}

template <class V>
void visit_fields(V& v, LightColor& c) {
  v.color("color", c.rgb, "of the light, r'g'b'");
  v.number("intensity", c.intensity, kBrightness, "times the colour");
}

template <class V>
void visit_fields(V& v, Falloff& f) {
  v.number("constant", f.constant, kNotNegative, "of 1 / (constant + linear d + quadratic d^2)");
  v.number("linear", f.linear, kNotNegative, "per unit of distance d");
  v.number("quadratic", f.quadratic, kNotNegative, "per unit of distance, squared");
}

template <class V>
void visit_fields(V& v, PointLight& l) {
  v.vector("position", l.position, "of the lamp");
  visit_fields(v, l.color);
  visit_fields(v, l.falloff);
}

template <class V>
void visit_fields(V& v, DirectionalLight& l) {
  v.vector("direction", l.direction, "in which it shines");
  visit_fields(v, l.color);
}

template <class V>
void visit_fields(V& v, SpotLight& l) {
  v.vector("position", l.position, "of the lamp");
  v.vector("direction", l.direction, "in which it shines");
  v.number("inner_degrees", l.inner_degrees, {.min = 0, .max = 180},
           "full within this angle of the axis");
  v.number("outer_degrees", l.outer_degrees, {.min = 0, .max = 180},
           "none beyond this angle of the axis");
  visit_fields(v, l.color);
  visit_fields(v, l.falloff);
}

template <class V>
void visit_fields(V& v, Material& m) {
  v.choice("model", m.model, kModelNames, "the lighting model");
  v.choice("space", m.space, kSpaceNames, "where light acts: every channel, or brightness alone");
  v.choice("form", m.form, kFormNames, "how the colour gets into the space and back");
  for (std::size_t i = 0; i < kParameterCount; ++i) {
    const Parameter& p = model_parameters()[i];
    v.number(p.name, m.parameters.at(i), p.range, p.meaning);
  }
  v.number("diffuse", m.diffuse, kBrightness, "weight of the diffuse term");
  v.number("specular", m.specular, kBrightness, "weight of the specular term");
  v.color("ambient_color", m.ambient_color, "of the surface in ambient light");
  v.color("diffuse_color", m.diffuse_color, "of the surface's diffuse term");
  v.color("specular_color", m.specular_color, "of the highlights");
  v.color("emissive", m.emissive, "the light that the surface emits");
  v.number("luma_offset", m.luma_offset, {.min = -kBrightest, .max = kBrightest},
           "added to the lit brightness; zero in space rgb");
  v.choice("clamp", m.clamp, kClampNames, "clamps of the paper's Table 1, or none");
  v.choice("gamut", m.gamut, kGamutNames, "treatment of colours outside [0, 1]");
  v.choice("normal", m.normal, kNormalNames, "renormalised per pixel, or as interpolated");
  v.choice("highlights", m.highlights, kHighlightNames, "gated: none where n.l <= 0");
  v.choice("rate", m.rate, kFrequencyNames,
           "light computed per pixel, or per vertex and interpolated");
}

template <class V>
void visit_fields(V& v, ImageSpec& i) {
  v.integer("width", i.width, {1, 65'536}, "pixels");
  v.integer("height", i.height, {1, 65'536}, "pixels");
  v.integer("samples", i.samples, {1, 64}, "n for n x n samples per pixel");
}

template <class V>
void visit_fields(V& v, SceneSpec& s) {
  v.one_of("mesh", s.mesh, "what is drawn");
  v.one_of("texture", s.texture, "the surface's colour");
  v.object("camera", s.view.camera, "a pinhole camera; right-handed, +Z up");
  v.list("lights", s.view.lights, kMaxLights, "the lamps");
  v.number("ambient", s.view.ambient, kBrightness, "ambient light");
  v.color("ambient_color", s.view.ambient_color, "of the ambient light, r'g'b'");
  v.object("material", s.view.material, "how the surface reflects the light");
  v.object("image", s.view.image, "the picture's size and samples");
}

template <class V>
void visit_value(V& v, KnotSpec& k) {
  v.object("knot", k, "a tube along a (p,q) torus knot");
}
template <class V>
void visit_value(V& v, MeshFile& f) {
  v.text("file", f.path, "a mesh file; relative to the scene file's folder");
}
template <class V>
void visit_value(V& v, Bricks&) {
  v.constant("builtin", "bricks", "a procedural brick wall, 512 x 512");
}
template <class V>
void visit_value(V& v, TextureFile& f) {
  v.text("file", f.path, "an image file; relative to the scene file's folder");
}
template <class V>
void visit_value(V& v, PlainColor& c) {
  v.color("color", c.rgb, "one r'g'b' colour, components in [0, 1]");
}

template <class V>
void visit_value(V& v, PointLight& l) {
  v.object("point", l, "a lamp that shines in all directions");
}
template <class V>
void visit_value(V& v, DirectionalLight& l) {
  v.object("directional", l, "a lamp at infinity");
}
template <class V>
void visit_value(V& v, SpotLight& l) {
  v.object("spot", l, "a lamp with a cone");
}

}  // namespace lumaknot
