#include "cli/commands/scene_input.h"

#include <fmt/format.h>

#include <iostream>
#include <iterator>

#include "exporters/image/file.h"
#include "exporters/mesh/file.h"
#include "meshgen/knot_mesh.h"
#include "scene/bricks.h"
#include "scene/json.h"
#include "scene/presets.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "system/overloaded.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

/// The knot for renderers: Babylon.js's triangles are clockwise, for its left-handed world.
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
        "scene {} is neither a file nor built in; lumaknot scene --list lists the built-in ones",
        source));
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
  // Reject a bad texture file before building the mesh.
  if (const auto* file = std::get_if<TextureFile>(&input.spec.texture)) {
    check_texture_file(input.folder / file->path, "texture.file");
  }
  return {load_mesh(input), load_texture(input), input.spec.view};
}

void check_not_input(const fs::path& output, const SceneInput& input, std::string_view flag) {
  const auto check = [&](const fs::path& file, std::string_view what) {
    std::error_code not_found;
    if (file.empty() || !fs::equivalent(output, file, not_found)) return;
    throw Error(fmt::format("{} {} would overwrite {}, which is an input; choose another place",
                            flag, output.string(), what));
  };
  check(input.file, "the scene");
  if (const auto* texture = std::get_if<TextureFile>(&input.spec.texture)) {
    check(input.folder / texture->path, "texture.file");
  }
  if (const auto* mesh = std::get_if<MeshFile>(&input.spec.mesh)) {
    check(input.folder / mesh->path, "mesh.file");
  }
}

}  // namespace lumaknot::cli
