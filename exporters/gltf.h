/// glTF 2.0 files, as https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html has them: a mesh,
/// or a scene with its surface, camera and lights.
///
/// glTF is right-handed with +Y up, so every node carries the turn from our +Z up, exactly, and the
/// arrays stay what they are. Its texture coordinates begin at the top left: v is written as 1 - v.
/// TANGENT.w is our sign as it is: glTF's bitangent, w cross(N, T), is that of normal maps whose +Y
/// is up in the image (normalTexture in the specification), so along decreasing v of glTF, which is
/// increasing v of ours. Blender's exporter likewise flips v and keeps MikkTSpace's sign.
///
/// Viewers light linear values with a fixed model. So colours of the surface and of the lights are
/// decoded from sRGB where glTF wants linear ones, and a surface in full white light shows the
/// encoded colour that we mean; shades between differ. With E = pi intensity a directional light
/// has E lux, as glTF's diffuse term is the base colour divided by pi. Point and spot lights have
/// E d^2 / (constant + linear d + quadratic d^2) candela: under glTF's 1/d^2 that is our light at
/// every distance when only `quadratic` is set, and else at the distance d of the camera's target.
/// Between a spot light's two angles glTF has another curve; angles beyond 90 degrees become 90.
/// Roughness is that of the GGX lobe as wide as the highlight: (2 / (k + 2))^(1/4) of Blinn's
/// exponent k, which is four times Phong's. Ambient light, lighting models and spaces have no
/// counterpart: `extras.lumaknot` of the material and of the scene hold all our numbers.
#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "exporters/package.h"
#include "scene/scene.h"

namespace lumaknot {

/// Writes `mesh` as a .glb file, converted to float32 on the way. Throws Error when it has no
/// triangles, a position beyond float32, or makes a file of 4 GiB or more. Whether all was written,
/// the stream knows.
void write_glb(std::ostream& stream, const TriangleMesh& mesh);

/// Writes `mesh` as a .gltf file to `json`, and to `binary` the file `binary_name` that must lie
/// beside it. Throws Error as write_glb() does, whatever the size.
void write_gltf(std::ostream& json, std::ostream& binary, const TriangleMesh& mesh,
                std::string_view binary_name);

/// NAME.glb, which holds the scene with its texture. Throws Error as write_glb() does.
Package glb_package(const Scene& scene, const std::string& name);

/// NAME.gltf, with NAME.bin and, unless the texture is a plain colour, NAME.texture.png beside it.
Package gltf_package(const Scene& scene, const std::string& name);

/// What every viewer of glTF draws otherwise than we do, as one clause.
inline constexpr std::string_view kGltfShortfall =
    "glTF's viewers light linear values with a model of their own and know no ambient light";

}  // namespace lumaknot
