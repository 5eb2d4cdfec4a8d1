#include "exporters/blender/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <nlohmann/json.hpp>

#include "exporters/image/baked_texture.h"
#include "exporters/image/file.h"
#include "scene/fields.h"
#include "shaders/formulas/lighting.h"
#include "shaders/graph/blender_nodes.h"
#include "shaders/languages/emit.h"
#include "system/error.h"

namespace lumaknot::embedded {
std::string_view blender_nodes_script();
std::string_view blender_osl_script();
std::string_view blender_scene_script();
}  // namespace lumaknot::embedded

namespace lumaknot::blender {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "the mesh file is little-endian");

template <class T>
void append(std::string& bytes, T value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  bytes.append(raw.data(), raw.size());
}

/// float32 positions (3 per vertex), normals (3), texture coordinates (2), int32 indices (3 per
/// triangle).
std::string mesh_bytes(const TriangleMesh& mesh) {
  std::string bytes;
  bytes.reserve(mesh.positions.size() * 32 + mesh.triangles.size() * 12);
  for (const auto* vectors : {&mesh.positions, &mesh.normals}) {
    for (const Vec3d& v : *vectors) {
      for (const double c : components(v)) append(bytes, float(c));
    }
  }
  for (const Vec2d& uv : mesh.uvs) {
    append(bytes, float(uv.u));
    append(bytes, float(uv.v));
  }
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t index : t) append(bytes, std::int32_t(index));
  }
  return bytes;
}

Json camera_json(const Camera& camera) {
  const CameraFrame frame = camera_frame(camera);
  return {{"position", components(camera.position)},
          {"right", components(frame.right)},
          {"up", components(frame.up)},
          {"back", components(frame.back)},
          {"fov_y_degrees", camera.fov_degrees},
          {"near_depth", near_depth(camera)}};
}

bool reads(const Recorded& recorded, std::string_view input) {
  return std::ranges::any_of(in_order({recorded.color}), [&](const Node* node) {
    return node->op == Op::kInput && node->name == input;
  });
}

/// Collects the files of a package while describing what refers to them.
class PackageWriter {
 public:
  PackageWriter(const Scene& scene, std::string name, ShotShaders shaders)
      : scene_(scene), name_(std::move(name)), shaders_(shaders) {}

  Package package;

  Json mesh() {
    const TriangleMesh& mesh = scene_.mesh;
    return {{"file", add(".mesh.bin", mesh_bytes(mesh))},
            {"vertices", mesh.positions.size()},
            {"triangles", mesh.triangles.size()}};
  }

  Json shot(const Shot& shot) {
    const Language language = shaders_ == ShotShaders::kOsl ? Language::kOsl : Language::kBlender;
    if (const auto why = language_shortfall(language, shot.material)) {
      throw Error(fmt::format("material.rate is \"vertex\": {}", *why));
    }
    const Recorded recorded = record_shot(scene_.view, shot);
    Json json{{"name", shot.name}};
    json.update(shaders_ == ShotShaders::kOsl ? script(shot) : blender_nodes(recorded.color));
    for (const char* input : {"texture", "texture_axes"}) {
      if (reads(recorded, input)) json[input] = texture(shot.material);
    }
    return json;
  }

 private:
  /// The file's name.
  std::string add(const std::string& ending, std::string bytes) {
    package.push_back({name_ + ending, std::move(bytes)});
    return package.back().name;
  }

  /// The texture in the material's form: {"file": ...} or {"color": [...]}.
  Json texture(const Material& material) {
    const auto* image = std::get_if<TextureImage>(&scene_.texture);
    if (!image) {
      return {{"color", components(texture_value(std::get<Vec3d>(scene_.texture), material))}};
    }
    const bool baked = material.form == Form::kBaked;
    const std::string_view space = kSpaceNames[std::size_t(material.space)];
    const std::string ending = baked ? fmt::format(".{}.axes.exr", space) : ".texture.png";
    const auto here = std::ranges::find(package, name_ + ending, &PackedFile::name);
    if (here != package.end()) return {{"file", here->name}};
    return {{"file", add(ending, baked ? texture_exr(baked_texture(*image, material))
                                       : texture_png(*image))}};
  }

  /// {"osl": file, "inputs": {"normal": "normal_value", ...}}, mapping our names to the shader's.
  Json script(const Shot& shot) {
    const ShaderJob job{shot.name, scene_.view, shot, Keep::kNeeded, std::nullopt};
    const Emission emission = emit(job, Language::kOsl);
    Json json{{"osl", add(fmt::format(".{}.osl", shot.name), emission.front().text)},
              {"inputs", Json::object()}};
    const Json parameters = Json::parse(emission.back().text);
    for (const Json& input : parameters.value("inputs", Json::array())) {
      json["inputs"][input["name"].get<std::string>()] = input["identifier"];
    }
    return json;
  }

  const Scene& scene_;
  std::string name_;
  ShotShaders shaders_;
};

/// The functions that scene.py calls: those of lumaknot_nodes.py, without the lines at its end that
/// run it as a program, and those of osl.py.
std::string functions_above(ShotShaders shaders) {
  const std::string_view nodes = embedded::blender_nodes_script();
  std::string text(nodes.substr(0, nodes.find("\n\nif __name__")));
  if (shaders == ShotShaders::kOsl) text += fmt::format("\n\n{}", embedded::blender_osl_script());
  return text;
}

}  // namespace

std::string_view blender_nodes_loader() { return embedded::blender_nodes_script(); }

Package blender_package(const Scene& scene, std::span<const Shot> shots, const std::string& name,
                        ShotShaders shaders) {
  PackageWriter writer(scene, name, shaders);
  const ImageSpec& image = scene.view.image;
  Json parameters{{"mesh", writer.mesh()},
                  {"camera", camera_json(scene.view.camera)},
                  {"image", {{"width", image.width}, {"height", image.height}}},
                  {"shots", Json::array()}};
  for (const Shot& shot : shots) parameters["shots"].push_back(writer.shot(shot));
  Package package = std::move(writer.package);
  // JSON escapes control characters and holds no triple quote outside a string; names are checked
  // by the caller, so nothing here ends the Python literal.
  package.push_back({name + ".py", fmt::format("# Made by lumaknot. blender --python {}.py\n"
                                               "import json\n\n"
                                               "PARAMETERS = json.loads(r'''{}''')\n\n{}\n\n{}",
                                               name, parameters.dump(1), functions_above(shaders),
                                               embedded::blender_scene_script())});
  return package;
}

}  // namespace lumaknot::blender
