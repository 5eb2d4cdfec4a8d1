/// Faults of normals and of the texture.
#include <cmath>

#include "validate/self_test/picture_faults.h"
#include "validate/self_test/planting.h"

namespace lumaknot::validate {
namespace {

template <class F>
Vec3d each(const Vec3d& c, F f) {
  return {f(c.x), f(c.y), f(c.z)};
}

double luma(const Vec3d& c) { return dot(Vec3d{0.29889531, 0.58662247, 0.11448223}, c); }

void add_normal_faults(Faults& all, const Scene& scene) {
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

}  // namespace

void add_surface_faults(Faults& all, const Scene& scene) {
  add_normal_faults(all, scene);
  if (std::holds_alternative<TextureImage>(scene.texture)) add_texture_faults(all, scene);
}

}  // namespace lumaknot::validate
