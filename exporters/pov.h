/// Scenes for POV-Ray 3.7.
///
/// POV-Ray's lighting is fixed, yet it draws both formulas natively. Classical Phong is a finish.
/// YIQ's eq. 6-8 collapse to F = T + Y (L_A + L_D - 1) + L_S + offset, an average of textures: one
/// that emits T and carries the highlight, one whose pigment is Y. Negative emission is legal;
/// negative colours are cut only where the image is written.
#pragma once

#include <optional>
#include <string>

#include "exporters/package.h"
#include "scene/scene.h"
#include "scene/shot.h"

namespace lumaknot {

/// What of `shot` POV-Ray can't express and draws in another way, or nothing.
std::optional<std::string> pov_shortfall(const Shot& shot);

/// The data of a mesh2: vertices, normals, texture coordinates, triangles. POV-Ray keeps float32.
std::string pov_mesh(const TriangleMesh& mesh);

/// The names of a POV-Ray scene's other files.
struct PovNames {
  std::string texture;  ///< an RGB PNG
  std::string luma;     ///< a 16-bit grey PNG
};

/// The scene that draws `shot`; `mesh` is the data of pov_mesh() or an #include of it.
std::string pov_scene(const Scene& scene, const Shot& shot, const PovNames& names,
                      std::string_view mesh);

/// The PNG files that `pov_scene` reads; none for a plain colour.
Package pov_textures(const Scene& scene, const PovNames& names);

/// NAME.pov, which draws the scene as it stands, with the images that it needs beside it.
Package pov_package(const Scene& scene, const std::string& name);

}  // namespace lumaknot
