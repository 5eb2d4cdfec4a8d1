#include "cli/scene_input.h"

#include <fmt/format.h>

#include <iostream>
#include <iterator>

#include "exporters/image_file.h"
#include "exporters/mesh_file.h"
#include "meshgen/knot_mesh.h"
#include "scene/atomic_file.h"
#include "scene/bricks.h"
#include "scene/error.h"
#include "scene/overloaded.h"
#include "scene/presets.h"
#include "scene/scene_json.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

/// The knot as renderers want it: Babylon.js's triangles are clockwise, for its left-handed world.
TriangleMesh knot_to_draw(const KnotSpec& knot) {
  TriangleMesh mesh = knot_mesh(knot);
  if (knot.convention != Convention::kBabylon) return mesh;
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TriangleMesh load_mesh(const SceneInput& input) {
  const bool needs_uvs = !std::holds_alternative<PlainColor>(input.spec.texture);
  return std::visit(Overloaded{[](const KnotSpec& knot) { return knot_to_draw(knot); },
                               [&](const MeshFile& file) {
                                 return read_mesh(input.folder / file.path, needs_uvs, "mesh.file");
                               }},
                    input.spec.mesh);
}

}  // namespace

SceneInput read_scene(const std::string& source) {
  if (source == "-") {
    const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    return {scene_from_json(text, "standard input"), ".", "/dev/stdin"};
  }
  std::error_code ignored;
  if (!fs::exists(source, ignored)) {
    if (const auto builtin = builtin_scene(source)) return {*builtin, ".", {}};
    throw Error(fmt::format(
        "scene {} is neither a file nor built in; `lumaknot scene --list` names those", source));
  }
  return {scene_from_json(read_file(source, "scene"), source), fs::path(source).parent_path(),
          source};
}

Texture load_texture(const SceneInput& input) {
  return std::visit(Overloaded{[](const Bricks&) -> Texture { return bricks(); },
                               [](const PlainColor& color) -> Texture { return color.rgb; },
                               [&](const TextureFile& file) -> Texture {
                                 return read_texture(input.folder / file.path, "texture.file");
                               }},
                    input.spec.texture);
}

Scene load_scene(const SceneInput& input) {
  // What is plainly wrong is refused before a mesh is made.
  if (const auto* file = std::get_if<TextureFile>(&input.spec.texture)) {
    check_texture_file(input.folder / file->path, "texture.file");
  }
  return {load_mesh(input), load_texture(input), input.spec.view};
}

void check_not_input(const fs::path& output, const SceneInput& input, std::string_view flag) {
  const auto check = [&](const fs::path& file, std::string_view what) {
    std::error_code is_not_there;
    if (file.empty() || !fs::equivalent(output, file, is_not_there)) return;
    throw Error(fmt::format("{} {} would overwrite {} that is read; choose another place", flag,
                            output.string(), what));
  };
  check(input.file, "the scene");
  if (const auto* texture = std::get_if<TextureFile>(&input.spec.texture)) {
    check(input.folder / texture->path, "the texture.file");
  }
  if (const auto* mesh = std::get_if<MeshFile>(&input.spec.mesh)) {
    check(input.folder / mesh->path, "the mesh.file");
  }
}

}  // namespace lumaknot
