/// Meshes in glTF 2.0 files.
#pragma once

#include <filesystem>
#include <string_view>

#include "exporters/mesh/polygons.h"

namespace lumaknot::gltf {

/// The triangles of all meshes in the default scene of a .glb or .gltf file, +Z up, each placed by
/// its nodes. Without a scene, those of all nodes. Triangles without normals are flat, as glTF
/// requires. Points, lines, materials, images, animations, skins and morph targets are left out.
/// External buffers are read only from the file's own folder and those below it. Throws Error
/// calling the file `name` and naming the place of the problem.
Polygons read_gltf(const std::filesystem::path& path, std::string_view name);

}  // namespace lumaknot::gltf
