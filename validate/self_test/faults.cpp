#include "validate/self_test/faults.h"

#include <algorithm>
#include <cmath>

#include "math/angle.h"
#include "validate/self_test/picture_faults.h"

namespace lumaknot::validate {
namespace {

using Faults = std::vector<Fault>;

/// A change of the scene as its view alone describes it.
template <class F>
std::function<void(Scene&, const KnotSpec*)> of_view(F change) {
  return [change](Scene& scene, const KnotSpec*) { change(scene.view); };
}

template <class F>
std::function<void(Scene&, const KnotSpec*)> of_material(F change) {
  return [change](Scene& scene, const KnotSpec*) { change(scene.view.material); };
}

template <class F>
std::function<void(Scene&, const KnotSpec*)> of_mesh(F change) {
  return [change](Scene& scene, const KnotSpec*) { change(scene.mesh); };
}

/// `turn` applied to every position and normal.
template <class F>
std::function<void(Scene&, const KnotSpec*)> turned(F turn) {
  return of_mesh([turn](TriangleMesh& mesh) {
    for (Vec3d& p : mesh.positions) p = turn(p);
    for (Vec3d& n : mesh.normals) n = turn(n);
  });
}

template <class F>
std::function<void(Scene&, const KnotSpec*)> of_uvs(F change) {
  return of_mesh([change](TriangleMesh& mesh) {
    for (Vec2d& uv : mesh.uvs) uv = change(uv);
  });
}

template <class F>
std::function<void(Scene&, const KnotSpec*)> of_texels(F change) {
  return [change](Scene& scene, const KnotSpec*) {
    for (Rgb& texel : std::get<TextureImage>(scene.texture).pixels)
      texel = to_rgb(change(to_vec(texel)));
  };
}

template <class F>
std::function<void(Scene&, const KnotSpec*)> of_knot(F change) {
  return [change](Scene& scene, const KnotSpec* knot) {
    KnotSpec other = *knot;
    change(other);
    scene.mesh = knot_mesh(other);
  };
}

template <class F>
Vec3d each(const Vec3d& c, F f) {
  return {f(c.x), f(c.y), f(c.z)};
}

double luma(const Vec3d& c) { return dot(Vec3d{0.29889531, 0.58662247, 0.11448223}, c); }

void add_camera_faults(Faults& all, const Scene& scene) {
  const Camera& camera = scene.view.camera;
  const double fov = camera.fov_degrees;
  for (const double factor : {0.5, 0.9, 1.02, 1.3}) {
    all.push_back({.what = "field of view",
                   .names = {"fov", "zoom"},
                   .numbers = {{"fov_degrees", factor * fov}},
                   .scene = of_view([factor](View& v) { v.camera.fov_degrees *= factor; })});
  }
  const Vec3d place = camera.position, target = camera.target;
  const double unit = 0.02 * length(place - target);
  const Vec3d by{unit, -0.6 * unit, 0.8 * unit};
  all.push_back({.what = "camera moved",
                 .names = {"camera-position"},
                 .numbers = {{"x", place.x + by.x}, {"y", place.y + by.y}, {"z", place.z + by.z}},
                 .scene = of_view([by](View& v) { v.camera.position = v.camera.position + by; })});
  all.push_back({.what = "camera looks elsewhere",
                 .names = {"camera-target", "shift"},
                 .numbers = {},
                 .scene = of_view([by](View& v) { v.camera.target = v.camera.target + by; })});
  for (const double degrees : {3.0, 30.0}) {
    all.push_back({.what = "camera rolled",
                   .names = {"camera-roll"},
                   .numbers = {{"degrees", degrees}},
                   .scene = of_view([degrees](View& v) {
                     const CameraFrame f = camera_frame(v.camera);
                     const double a = degrees * kDegree;
                     v.camera.up = f.up * std::cos(a) + f.right * std::sin(a);
                   })});
  }
}

void add_mesh_faults(Faults& all) {
  for (const double scale : {0.98, 1.1, 0.5}) {
    all.push_back({.what = "mesh scaled",
                   .names = {"mesh-scale"},
                   .numbers = {{"scale", scale}},
                   .scene = of_mesh([scale](TriangleMesh& mesh) {
                     for (Vec3d& p : mesh.positions) p = p * scale;
                   })});
  }
  all.push_back({.what = "mesh moved",
                 .names = {"mesh-moved"},
                 .numbers = {{"x", 0.05}, {"y", 0.02}, {"z", -0.03}},
                 .scene = of_mesh([](TriangleMesh& mesh) {
                   for (Vec3d& p : mesh.positions) p = p + Vec3d{0.05, 0.02, -0.03};
                 })});
  all.push_back({.what = "mesh rotated about z",
                 .names = {"mesh-rotated"},
                 .numbers = {{"degrees", 7}},
                 .scene = turned([](const Vec3d& v) {
                   const double c = std::cos(7 * kDegree), s = std::sin(7 * kDegree);
                   return Vec3d{c * v.x - s * v.y, s * v.x + c * v.y, v.z};
                 })});
  all.push_back({.what = "y axis up", .names = {"mesh-y-up"}, .scene = turned([](const Vec3d& v) {
                                                                return Vec3d{v.x, -v.z, v.y};
                                                              })});
  all.push_back({.what = "y axis up, inverse",
                 .names = {"mesh-y-up-inverse"},
                 .scene = turned([](const Vec3d& v) { return Vec3d{v.x, v.z, -v.y}; })});
  all.push_back({.what = "y and z exchanged",
                 .names = {"mesh-yz-exchanged"},
                 .scene = turned([](const Vec3d& v) { return Vec3d{v.x, v.z, v.y}; })});
  all.push_back({.what = "mesh mirrored in x",
                 .names = {"mesh-mirrored-x"},
                 .scene = turned([](const Vec3d& v) { return Vec3d{-v.x, v.y, v.z}; })});
  all.push_back({.what = "mesh mirrored in z",
                 .names = {"mesh-mirrored-z"},
                 .scene = turned([](const Vec3d& v) { return Vec3d{v.x, v.y, -v.z}; })});
}

void add_knot_faults(Faults& all, const KnotSpec& knot) {
  all.push_back({.what = "p and q exchanged",
                 .names = {"knot-" + std::to_string(knot.q) + "-" + std::to_string(knot.p)},
                 .scene = of_knot([](KnotSpec& k) { std::swap(k.p, k.q); })});
  all.push_back({.what = "thicker tube",
                 .names = {"tube_radius"},
                 .numbers = {{"tube_radius", 1.1 * knot.tube_radius}},
                 .scene = of_knot([](KnotSpec& k) { k.tube_radius *= 1.1; })});
  all.push_back({.what = "larger minor radius",
                 .names = {"minor_radius"},
                 .numbers = {{"minor_radius", 1.05 * knot.minor_radius}},
                 .scene = of_knot([](KnotSpec& k) { k.minor_radius *= 1.05; })});
  all.push_back({.what = "a quarter of the segments and sides",
                 .names = {"grid-" + std::to_string(knot.segments / 4) + "x" +
                           std::to_string(knot.sides / 4)},
                 .scene = of_knot([](KnotSpec& k) { k.segments /= 4, k.sides /= 4; })});
}

void add_surface_faults(Faults& all, const Scene& scene) {
  all.push_back({.what = "flat triangles",
                 .names = {"normals-flat"},
                 .scene = [](Scene& s, const KnotSpec*) { s.mesh = with_flat_normals(s.mesh); }});
  all.push_back({.what = "normals inverted",
                 .names = {"normals-inverted"},
                 .scene = of_mesh([](TriangleMesh& mesh) {
                   for (Vec3d& n : mesh.normals) n = -n;
                 })});
  all.push_back({.what = "normals not renormalised or the other way round",
                 .names = {scene.view.material.normal == NormalUse::kUnit ? "normals-not-unit"
                                                                          : "normals-unit"},
                 .scene = of_material([](Material& m) {
                   m.normal =
                       m.normal == NormalUse::kUnit ? NormalUse::kInterpolated : NormalUse::kUnit;
                 })});
  all.push_back({.what = "light per vertex",
                 .names = {"light-per-vertex"},
                 .scene = of_material([](Material& m) { m.rate = ShadingFrequency::kVertex; })});
}

void add_texture_faults(Faults& all, const Scene& scene) {
  all.push_back({.what = "V flipped", .names = {"texture-flip-v"}, .scene = of_uvs([](Vec2d uv) {
                                                                     return Vec2d{uv.u, 1 - uv.v};
                                                                   })});
  all.push_back({.what = "U flipped", .names = {"texture-flip-u"}, .scene = of_uvs([](Vec2d uv) {
                                                                     return Vec2d{1 - uv.u, uv.v};
                                                                   })});
  all.push_back({.what = "U and V exchanged",
                 .names = {"texture-uv-exchanged"},
                 .scene = of_uvs([](Vec2d uv) { return Vec2d{uv.v, uv.u}; })});
  for (const double times : {2.0, 0.5, 1.25}) {
    all.push_back({.what = "number of tiles along u",
                   .names = {"texture-repeat"},
                   .numbers = {{"u", times}, {"v", 1}},
                   .scene = of_uvs([times](Vec2d uv) { return Vec2d{times * uv.u, uv.v}; })});
  }
  all.push_back({.what = "number of tiles along both",
                 .names = {"texture-repeat"},
                 .numbers = {{"u", 2}, {"v", 2}},
                 .scene = of_uvs([](Vec2d uv) { return Vec2d{2 * uv.u, 2 * uv.v}; })});
  all.push_back({.what = "texture moved",
                 .names = {"texture-offset"},
                 .numbers = {{"u", 0.15}, {"v", 0.3}},
                 .scene = of_uvs([](Vec2d uv) { return Vec2d{uv.u + 0.15, uv.v + 0.3}; })});
  const auto& image = std::get<TextureImage>(scene.texture);
  const double w = image.width, h = image.height;
  all.push_back(
      {.what = "half a texel",
       .names = {"half-texel", "texel-shift"},
       .scene = of_uvs([w, h](Vec2d uv) { return Vec2d{uv.u + 0.5 / w, uv.v + 0.5 / h}; })});
  all.push_back({.what = "texture to the power 2.2",
                 .names = {"texture-gamma"},
                 .numbers = {{"exponent", 2.2}},
                 .scene = of_texels([](const Vec3d& c) {
                   return each(c, [](double x) { return std::pow(x, 2.2); });
                 })});
  all.push_back({.what = "texture decoded from sRGB",
                 .names = {"texture-decoded"},
                 .scene = of_texels(decoded_srgb)});
  all.push_back({.what = "texture encoded as sRGB",
                 .names = {"texture-encoded"},
                 .scene = of_texels(encoded_srgb)});
  all.push_back({.what = "red and blue of the texture exchanged",
                 .names = {"texture-channels-bgr"},
                 .scene = of_texels([](const Vec3d& c) { return Vec3d{c.z, c.y, c.x}; })});
  all.push_back(
      {.what = "texture in grey",
       .names = {"texture-grey", "texture-saturation"},
       .scene = of_texels([](const Vec3d& c) { return Vec3d{luma(c), luma(c), luma(c)}; })});
  all.push_back({.what = "no texture",
                 .names = {"texture-missing"},
                 .numbers = {{"r", 0.8}, {"g", 0.8}, {"b", 0.8}},
                 .scene = [](Scene& s, const KnotSpec*) { s.texture = Vec3d{0.8, 0.8, 0.8}; }});
}

void add_lamp_faults(Faults& all, const Scene& scene) {
  const auto* lamp = std::get_if<PointLight>(&scene.view.lights.front());
  if (!lamp) return;
  const std::string light = scene.view.lights.size() > 1 ? "light-1-" : "light-";
  const std::string suffix = scene.view.lights.size() > 1 ? "-1" : "";
  const auto of_lamp = [](auto change) {
    return of_view([change](View& v) { change(std::get<PointLight>(v.lights.front())); });
  };
  const Vec3d p = lamp->position;
  all.push_back({.what = "lamp moved a little",
                 .names = {light + "position"},
                 .numbers = {{"x", p.x}, {"y", p.y}, {"z", p.z - 0.3}},
                 .scene = of_lamp([](PointLight& l) { l.position.z -= 0.3; })});
  all.push_back({.what = "lamp mirrored",
                 .names = {light + "position"},
                 .numbers = {{"x", -p.x}, {"y", p.y}, {"z", p.z}},
                 .scene = of_lamp([](PointLight& l) { l.position.x *= -1; })});
  for (const double factor : {0.5, 1.02, 2.0}) {
    all.push_back({.what = "lamp's intensity",
                   .names = {light + "intensity", "exposure"},
                   .numbers = {{"factor", factor}},
                   .scene = of_lamp([factor](PointLight& l) { l.color.intensity *= factor; })});
  }
  all.push_back({.what = "lamp times pi",
                 .names = {light + "times-pi", light + "intensity"},
                 .scene = of_lamp([](PointLight& l) { l.color.intensity *= kPi; })});
  all.push_back({.what = "lamp divided by pi",
                 .names = {light + "by-pi", light + "intensity"},
                 .scene = of_lamp([](PointLight& l) { l.color.intensity /= kPi; })});
  all.push_back({.what = "no lamp",
                 .names = {light + "missing", light + "intensity"},
                 .scene = of_lamp([](PointLight& l) { l.color.intensity = 0; })});
  all.push_back({.what = "light falls off with the square",
                 .names = {"falloff-quadratic" + suffix},
                 .numbers = {{"scale", 0.05}},
                 .scene = of_lamp([](PointLight& l) { l.falloff = {0, 0, 0.05}; })});
  all.push_back({.what = "light falls off linearly",
                 .names = {"falloff-linear" + suffix},
                 .numbers = {{"scale", 0.25}},
                 .scene = of_lamp([](PointLight& l) { l.falloff = {0, 0.25, 0}; })});
  all.push_back({.what = "directional light instead",
                 .names = {"directional" + suffix},
                 .scene = of_view([](View& v) {
                   const auto l = std::get<PointLight>(v.lights.front());
                   v.lights.front() = DirectionalLight{-l.position, l.color};
                 })});
  if (scene.view.material.space == Space::kRgb) {
    all.push_back({.what = "lamp tinted",
                   .names = {light + "color", "white-balance"},
                   .numbers = {{"r", 1}, {"g", 0.8}, {"b", 0.6}},
                   .scene = of_lamp([](PointLight& l) { l.color.rgb = {1, 0.8, 0.6}; })});
  }
}

void add_light_faults(Faults& all, const Scene& scene) {
  const View& view = scene.view;
  all.push_back({.what = "another lamp",
                 .names = {"extra-light"},
                 .numbers = {{"x", 2}, {"y", -2}, {"z", 1}, {"intensity", 0.4}},
                 .scene = of_view([](View& v) {
                   v.lights.emplace_back(PointLight{{2, -2, 1}, {{1, 1, 1}, 0.4}, {}});
                 })});
  all.push_back({.what = "headlight",
                 .names = {"headlight", "extra-light"},
                 .numbers = {{"intensity", 0.3}},
                 .scene = of_view([](View& v) {
                   v.lights.emplace_back(PointLight{v.camera.position, {{1, 1, 1}, 0.3}, {}});
                 })});
  for (const double value : {0.5 * view.ambient, 2 * view.ambient, view.ambient + 0.3}) {
    all.push_back({.what = "ambient light",
                   .names = {"ambient", "emissive", "ambient-color"},
                   .numbers = {{"ambient", value}},
                   .scene = of_view([value](View& v) { v.ambient = value; })});
  }
  all.push_back({.what = "no ambient light",
                 .names = {"ambient-none", "ambient", "ambient-color"},
                 .scene = of_view([](View& v) { v.ambient = 0; })});
  for (const double factor : {0.5, 0.9, 1.5}) {
    all.push_back({.what = "diffuse weight",
                   .names = {"diffuse"},
                   .numbers = {{"factor", factor}},
                   .scene = of_material([factor](Material& m) { m.diffuse *= factor; })});
    all.push_back({.what = "specular weight",
                   .names = {"specular", "specular-color"},
                   .numbers = {{"factor", factor}},
                   .scene = of_material([factor](Material& m) { m.specular *= factor; })});
  }
  all.push_back({.what = "no highlights",
                 .names = {"specular-none", "specular"},
                 .scene = of_material([](Material& m) { m.specular = 0; })});
  all.push_back({.what = "no diffuse light",
                 .names = {"diffuse-none", "diffuse"},
                 .scene = of_material([](Material& m) { m.diffuse = 0; })});
  all.push_back({.what = "highlights gated or not",
                 .names = {view.material.highlights == Highlights::kFree ? "highlights-gated"
                                                                         : "highlights-free"},
                 .scene = of_material([](Material& m) {
                   m.highlights =
                       m.highlights == Highlights::kFree ? Highlights::kGated : Highlights::kFree;
                 })});
  if (view.material.space == Space::kRgb) {
    all.push_back({.what = "highlights tinted",
                   .names = {"specular-color"},
                   .numbers = {{"r", 1}, {"g", 0.7}, {"b", 0.4}},
                   .scene = of_material([](Material& m) { m.specular_color = {1, 0.7, 0.4}; })});
  }
}

void add_model_faults(Faults& all, const Scene& scene) {
  const Material& own = scene.view.material;
  if (own.model == Model::kPhong || own.model == Model::kBlinnPhong) {
    for (const double shininess : {10.0, 50.0, 200.0}) {
      all.push_back({.what = "shininess",
                     .names = {"shininess"},
                     .numbers = {{"shininess", shininess}},
                     .scene = of_material(
                         [shininess](Material& m) { m.parameters["shininess"] = shininess; })});
    }
  }
  for (std::size_t m = 0; m < kModelNames.size(); ++m) {
    if (Model(m) == own.model) continue;
    all.push_back({.what = std::string(kModelNames[m]) + " instead",
                   .names = {"model-" + std::string(kModelNames[m])},
                   .scene = of_material([m](Material& material) { material.model = Model(m); })});
  }
  const auto space = [&](std::string_view name, Space value) {
    if (own.space == value) return;
    all.push_back({.what = "light in " + std::string(name),
                   .names = {"space-" + std::string(name)},
                   .scene = of_material([value](Material& m) { m.space = value; })});
  };
  space("rgb", Space::kRgb);
  space("yiq", Space::kYiq);
  space("yuv709", Space::kYuv709);
  space("cielab", Space::kCielab);
  if (own.clamp == Clamp::kFree) {
    all.push_back({.what = "Table 1's clamps",
                   .names = {"clamp-table1"},
                   .scene = of_material([](Material& m) { m.clamp = Clamp::kTable1; })});
  }
}

}  // namespace

std::vector<Fault> planted_faults(const Scene& scene, const KnotSpec* knot) {
  Faults all = picture_faults();
  add_camera_faults(all, scene);
  add_mesh_faults(all);
  if (knot) add_knot_faults(all, *knot);
  add_surface_faults(all, scene);
  if (std::holds_alternative<TextureImage>(scene.texture)) add_texture_faults(all, scene);
  add_lamp_faults(all, scene);
  add_light_faults(all, scene);
  add_model_faults(all, scene);
  return all;
}

}  // namespace lumaknot::validate
