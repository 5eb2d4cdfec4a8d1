/// glTF 2.0 files, as defined by https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html: a mesh,
/// or a scene with its surface, camera and lights.
///
/// glTF is right-handed with +Y up, so every node carries the rotation from our +Z up, exactly, and
/// the arrays stay as they are. Its texture coordinates begin at the top left: v is written as 1 -
/// v. TANGENT.w is our sign unchanged: glTF's bitangent, w cross(N, T), is that of normal maps
/// whose +Y is up in the image (normalTexture in the specification), so along decreasing v of glTF,
/// which is increasing v of ours. Blender's exporter likewise flips v and keeps MikkTSpace's sign.
///
/// Viewers light linear values with a fixed model. So colours of the surface and of the lights are
/// decoded from sRGB where glTF expects linear ones, and a surface in full white light shows our
/// encoded colour; intermediate shades differ. With E = pi intensity a directional light has E lux,
/// as glTF's diffuse term is the base colour divided by pi. Point and spot lights have E d^2 /
/// (constant + linear d + quadratic d^2) candela: under glTF's 1/d^2 that is our light at every
/// distance when only `quadratic` is set, and otherwise at the distance d of the camera's target.
/// Between a spot light's two angles glTF uses another curve; angles beyond 90 degrees become 90.
/// Roughness is that of the GGX lobe as wide as the highlight: (2 / (k + 2))^(1/4) of Blinn's
/// exponent k, which is four times Phong's. Ambient light, lighting models and spaces have no
/// counterpart: `extras.lumaknot` of the material and of the scene contain all our numbers.
#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "exporters/package.h"
#include "scene/spec.h"

namespace lumaknot::gltf {

/// Writes `mesh` as a .glb file, converted to float32 on the way. Throws Error when it has no
/// triangles, a position beyond float32, or needs a file of 4 GiB or more. The stream's state
/// reports whether everything was written.
void write_glb(std::ostream& stream, const TriangleMesh& mesh);

/// Writes `mesh` as a .gltf file to `json`, and to `binary` the file `binary_name` that belongs in
/// the same folder. Throws Error as write_glb() does, but not for size.
void write_gltf(std::ostream& json, std::ostream& binary, const TriangleMesh& mesh,
                std::string_view binary_name);

/// NAME.glb with the scene and its texture. Throws Error as write_glb() does.
Package glb_package(const Scene& scene, const std::string& name);

/// NAME.gltf, with NAME.bin and, unless the texture is a plain colour, NAME.texture.png.
Package gltf_package(const Scene& scene, const std::string& name);

/// How every viewer of glTF draws differently from us, as one clause.
inline constexpr std::string_view kGltfShortfall =
    "glTF's viewers light linear values with a model of their own and know no ambient light";

}  // namespace lumaknot::gltf
