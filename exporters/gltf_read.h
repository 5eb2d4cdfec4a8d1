/// Meshes in glTF 2.0 files.
#pragma once

#include <filesystem>
#include <string_view>

#include "exporters/polygons.h"

namespace lumaknot {

/// The triangles of all meshes in the default scene of a .glb or .gltf file, +Z up, each as its
/// nodes place it. Without a scene, those of all nodes. Triangles without normals are flat, as
/// glTF wants it. Points, lines, materials, images, animations, skins and morph targets are left
/// out. External buffers are read from the file's own folder and those below it alone. Throws
/// Error calling the file `name` and saying where in it what is wrong.
Polygons read_gltf(const std::filesystem::path& path, std::string_view name);

}  // namespace lumaknot
