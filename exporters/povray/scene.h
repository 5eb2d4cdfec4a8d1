/// Scenes for POV-Ray 3.7.
///
/// POV-Ray's lighting is fixed: Lambert's diffuse term, Phong's highlight or Blinn's, coloured
/// lights. In space rgb that is the formula. In a linear space of brightness eq. 6-8 collapse to F
/// = T + Y (L_A + L_D - 1) + L_S + offset, an average of textures: one that emits T and carries the
/// highlight, one whose pigment is Y. Negative emission is legal; negative colours are clipped only
/// when the image is written.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "exporters/package.h"
#include "scene/shot.h"
#include "scene/spec.h"

namespace lumaknot::povray {

/// Why POV-Ray can't draw `shot` by its own lighting, or empty when it can. That it turns normals
/// to the viewer and leaves out highlights where n.l <= 0 is not reported here.
std::optional<std::string> pov_shortfall(const View& view, const Shot& shot);

/// Which light of `shot` POV-Ray can't draw at all, and the nearest that it can; if empty, the
/// final picture can be composed from its texture, diffuse and specular stages. Always a shortfall
/// too.
std::optional<std::string> pov_missing_term(const View& view, const Shot& shot);

/// Throws Error with the shortfall and the nearest alternative where the scene of `shot` would
/// otherwise be another formula.
void check_pov_export(const View& view, const Shot& shot);

/// Whether `shot` shows L_D, L_S: it is that term, or final with a nonzero weight and a light.
bool needs_diffuse(const View& view, const Shot& shot);
bool needs_specular(const View& view, const Shot& shot);

/// Where POV-Ray's world lies in the scene's.
struct Placement {
  Vec3d origin;      ///< in the scene's world
  double scale = 1;  ///< of lengths, a power of two
  friend bool operator==(const Placement&, const Placement&) = default;
};

/// The placement in which POV-Ray can draw the mesh: it drops triangles and hits smaller than
/// constants of its own, and keeps float32 vertices, which are too coarse far from the origin. The
/// scene's own world for a mesh of 0.01 to 100,000 units that is at most 100 times its size away.
Placement pov_placement(const TriangleMesh& mesh);

/// The same picture of the scene, in that placement.
Scene placed(Scene scene, const Placement& placement);

/// The data of a mesh2: vertices, normals, texture coordinates, triangles. POV-Ray keeps float32.
std::string pov_mesh(const TriangleMesh& mesh);

/// The scene that draws `shot`, which must not lack a term and, when final, must be of space rgb or
/// a linear one; other shortfalls are left out. `mesh` is the data of pov_mesh() or an #include of
/// it; `prefix` begins the names of the image files.
std::string pov_scene(const View& view, const Texture& texture, const Shot& shot,
                      const std::string& prefix, std::string_view mesh);

/// The PNG files that the scenes of `shots` read: PREFIXtexture.png, and PREFIXyiq-luma.png and the
/// like, 16-bit grey. Empty for a plain colour.
Package pov_textures(const Texture& texture, std::span<const Shot> shots,
                     const std::string& prefix);

/// NAME.pov, which draws the scene without further input, with the images that it needs. Clamps,
/// unnormalised normals and the gamut rule are left out, with a comment that says so, and the scene
/// as pov_placement() has it. Throws Error as check_pov_export() does.
Package pov_package(const Scene& scene, const std::string& name);

}  // namespace lumaknot::povray
