/// A scene's surface for tools that read Wavefront OBJ.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "exporters/package.h"
#include "scene/spec.h"

namespace lumaknot::obj {

/// NAME.mtl, whose one material is "lumaknot", and NAME.texture.png unless the texture is a plain
/// colour. MTL's lighting is in space rgb and has Lambert's term and a highlight (illum 2): Kd is
/// the diffuse weight and colour, times a plain texture, Ks the specular ones, Ns the shininess.
/// Ambient and emitted light, lights and camera can't be expressed. Spaces and '#' in `name`, which
/// readers take as the end of a name, become '_' in the names of the files. Without the mesh; the
/// .mtl is the last.
Package obj_materials(const Scene& scene, const std::string& name);

/// Writes the surface to `path`, which ends in .obj, and before it `materials`, the result of
/// obj_materials(), into the same folder. Returns the names of the files, that of `path` last.
/// `flag` names it in an Error.
std::vector<std::string> write_obj_scene(const std::filesystem::path& path,
                                         const TriangleMesh& mesh, const Package& materials,
                                         std::string_view flag);

}  // namespace lumaknot::obj
