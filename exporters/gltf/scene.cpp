#include "exporters/gltf/scene.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "exporters/gltf/document.h"
#include "exporters/image/file.h"
#include "math/angle.h"
#include "scene/json.h"
#include "shaders/spaces/srgb.h"
#include "system/overloaded.h"

namespace lumaknot::gltf {
namespace {

using Json = nlohmann::ordered_json;

std::array<double, 3> decoded(const Vec3d& encoded) {
  return {decode_srgb(encoded.x), decode_srgb(encoded.y), decode_srgb(encoded.z)};
}

/// The numbers of a scene as in scene.json, without mesh and texture.
Json numbers_of(const View& view) {
  Json numbers = Json::parse(scene_to_json({KnotSpec{}, PlainColor{}, view}));
  numbers.erase("mesh");
  numbers.erase("texture");
  return numbers;
}

/// The square root of GGX's alpha.
double roughness_of(const Material& m) {
  if (m.specular == 0) return 1;
  return with_highlight(m.model, m.parameters,
                        [](auto term, auto... p) { return term.ggx_roughness(p...); });
}

/// The axes of an object that looks along `direction`, as glTF's cameras and lights look along -Z.
CameraFrame axes_along(const Vec3d& direction) {
  const Vec3d forward = normalize(direction);
  const Vec3d up = std::abs(forward.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
  return camera_frame({.position = {}, .target = forward, .up = up});
}

/// Candela of a lamp that is as bright as ours at the camera's target; see scene.h.
double candela(const LightColor& color, const Falloff& f, const Vec3d& position,
               const Vec3d& target) {
  const double distance = length(target - position);
  const double d = distance > 0 ? distance : 1;
  return kPi * color.intensity / (f.constant / (d * d) + f.linear / d + f.quadratic);
}

Json spot_cone(const SpotLight& light) {
  constexpr double kWidest = 90, kMinEdge = 0.1;  // degrees
  const double outer = std::min(light.outer_degrees, kWidest);
  const double inner = std::min(light.inner_degrees, outer - kMinEdge);
  return {{"innerConeAngle", std::max(inner, 0.0) * kPi / 180},
          {"outerConeAngle", outer * kPi / 180}};
}

/// A light of KHR_lights_punctual, and the matrix of its node.
struct PlacedLight {
  Json light, matrix;
};

PlacedLight placed(const Light& light, const Vec3d& target) {
  const auto source = [](const char* type, const LightColor& color, double intensity) {
    return Json{{"type", type}, {"color", decoded(color.rgb)}, {"intensity", intensity}};
  };
  return std::visit(
      Overloaded{
          [&](const PointLight& l) -> PlacedLight {
            return {source("point", l.color, candela(l.color, l.falloff, l.position, target)),
                    gltf_matrix(axes_along({0, 1, 0}), l.position)};
          },
          [&](const DirectionalLight& l) -> PlacedLight {
            return {source("directional", l.color, kPi * l.color.intensity),
                    gltf_matrix(axes_along(l.direction), {})};
          },
          [&](const SpotLight& l) -> PlacedLight {
            Json json = source("spot", l.color, candela(l.color, l.falloff, l.position, target));
            json["spot"] = spot_cone(l);
            return {json, gltf_matrix(axes_along(l.direction), l.position)};
          }},
      light);
}

/// Adds a node of the scene. An identity matrix is left out.
void add_node(GltfDocument& document, Json node) {
  const Json unit{1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1.};
  if (node["matrix"] == unit) node.erase("matrix");
  document.json["scenes"][0]["nodes"].push_back(document.add("nodes", std::move(node)));
}

void add_camera(GltfDocument& document, const View& view) {
  const Camera& camera = view.camera;
  const Json perspective{{"aspectRatio", double(view.image.width) / view.image.height},
                         {"yfov", camera.fov_degrees * kPi / 180},
                         {"znear", near_depth(camera)}};
  document.add("cameras", {{"type", "perspective"}, {"perspective", perspective}});
  add_node(document, {{"name", "camera"},
                      {"camera", 0},
                      {"matrix", gltf_matrix(camera_frame(camera), camera.position)}});
}

void add_lights(GltfDocument& document, const View& view) {
  if (view.lights.empty()) return;
  constexpr const char* kExtension = "KHR_lights_punctual";
  Json lights = Json::array();
  for (const Light& light : view.lights) {
    const PlacedLight here = placed(light, view.camera.target);
    add_node(document, {{"name", "light" + std::to_string(lights.size())},
                        {"matrix", here.matrix},
                        {"extensions", {{kExtension, {{"light", lights.size()}}}}}});
    lights.push_back(here.light);
  }
  document.json["extensionsUsed"] = {kExtension};
  document.json["extensions"] = {{kExtension, {{"lights", lights}}}};
}

/// The base colour's texture, repeated and filtered with mipmaps.
Json add_texture(GltfDocument& document, Json image) {
  constexpr int kLinear = 9729, kLinearMipmapLinear = 9987, kRepeat = 10497;
  document.add("images", std::move(image));
  document.add("samplers", {{"magFilter", kLinear},
                            {"minFilter", kLinearMipmapLinear},
                            {"wrapS", kRepeat},
                            {"wrapT", kRepeat}});
  return {{"index", document.add("textures", {{"sampler", 0}, {"source", 0}})}};
}

/// Adds the surface. `image` is the texture's, null for a plain colour.
void add_material(GltfDocument& document, const Scene& scene, Json image) {
  Json surface{{"metallicFactor", 0}, {"roughnessFactor", roughness_of(scene.view.material)}};
  if (const auto* color = std::get_if<Vec3d>(&scene.texture)) {
    const auto [r, g, b] = decoded(*color);
    surface["baseColorFactor"] = {r, g, b, 1};
  } else {
    surface["baseColorTexture"] = add_texture(document, std::move(image));
  }
  document.json["meshes"][0]["primitives"][0]["material"] =
      document.add("materials", {{"name", "surface"},
                                 {"pbrMetallicRoughness", surface},
                                 {"extras", {{"lumaknot", numbers_of(scene.view)["material"]}}}});
}

/// The document of `scene` except for its surface.
GltfDocument scene_document(const Scene& scene) {
  GltfDocument document(scene.mesh);
  add_camera(document, scene.view);
  add_lights(document, scene.view);
  Json numbers = numbers_of(scene.view);
  numbers.erase("material");
  document.json["scenes"][0]["extras"] = {{"lumaknot", numbers}};
  return document;
}

/// The texture's PNG file, which glTF takes as sRGB; empty for a plain colour.
std::string texture_bytes(const Scene& scene) {
  const auto* image = std::get_if<TextureImage>(&scene.texture);
  return image ? texture_png(*image) : std::string();
}

}  // namespace

void write_glb(std::ostream& stream, const TriangleMesh& mesh) {
  write_container(stream, GltfDocument(mesh), mesh, {});
}

void write_gltf(std::ostream& json, std::ostream& binary, const TriangleMesh& mesh,
                std::string_view binary_name) {
  json << GltfDocument(mesh).text(binary_name) << '\n';
  write_arrays(binary, mesh);
}

Package glb_package(const Scene& scene, const std::string& name) {
  GltfDocument document = scene_document(scene);
  const std::string png = texture_bytes(scene);
  Json image;
  if (!png.empty()) {
    image = {{"bufferView", document.add_view(png.size())}, {"mimeType", "image/png"}};
  }
  add_material(document, scene, std::move(image));
  std::ostringstream stream;
  write_container(stream, document, scene.mesh, png);
  return {{name + ".glb", std::move(stream).str()}};
}

Package gltf_package(const Scene& scene, const std::string& name) {
  const std::string binary_name = name + ".bin", texture_name = name + ".texture.png";
  GltfDocument document = scene_document(scene);
  add_material(document, scene, {{"uri", gltf_uri(texture_name)}});
  std::ostringstream binary;
  write_arrays(binary, scene.mesh);
  Package package{{binary_name, std::move(binary).str()}};
  if (std::string png = texture_bytes(scene); !png.empty()) {
    package.push_back({texture_name, std::move(png)});
  }
  package.push_back({name + ".gltf", document.text(binary_name) + '\n'});
  return package;
}

}  // namespace lumaknot::gltf
