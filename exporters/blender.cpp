#include "exporters/blender.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <nlohmann/json.hpp>

#include "exporters/image_file.h"
#include "shaders/blender_nodes.h"
#include "shaders/record.h"

namespace lumaknot {
namespace embedded {
std::string_view blender_scene_script();
}
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "the mesh file is little-endian");

template <class T>
void append(std::string& bytes, T value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  bytes.append(raw.data(), raw.size());
}

/// float32 positions (3 a vertex), normals (3), texture coordinates (2), int32 indices (3 a
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

Json shots_json(const View& view, std::span<const Shot> shots) {
  Json list = Json::array();
  for (const Shot& shot : shots) {
    Json entry{{"name", shot.name}};
    entry.update(blender_nodes(record_shot(view, shot)));
    list.push_back(entry);
  }
  return list;
}

}  // namespace

Package blender_package(const Scene& scene, std::span<const Shot> shots, const std::string& name) {
  Package package{{name + ".mesh.bin", mesh_bytes(scene.mesh)}};
  Json texture;
  if (const auto* image = std::get_if<TextureImage>(&scene.texture)) {
    package.push_back({name + ".texture.png", texture_png(*image)});
    texture = {{"file", name + ".texture.png"}};
  } else {
    texture = {{"color", components(std::get<Vec3d>(scene.texture))}};
  }
  const Json parameters{
      {"mesh",
       {{"file", name + ".mesh.bin"},
        {"vertices", scene.mesh.positions.size()},
        {"triangles", scene.mesh.triangles.size()}}},
      {"texture", texture},
      {"camera", camera_json(scene.view.camera)},
      {"image", {{"width", scene.view.image.width}, {"height", scene.view.image.height}}},
      {"shots", shots_json(scene.view, shots)}};
  // JSON escapes control characters and holds no triple quote outside a string; names are checked
  // by the caller, so nothing here ends the Python literal.
  package.push_back(
      {name + ".py", fmt::format("# Made by lumaknot. blender --python {}.py\n"
                                 "import json\n\n"
                                 "PARAMETERS = json.loads(r'''{}''')\n\n{}",
                                 name, parameters.dump(1), embedded::blender_scene_script())});
  return package;
}

}  // namespace lumaknot
