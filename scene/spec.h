/// The contents of a picture: the description (`SceneSpec`, as in scene.json) and, with the mesh
/// built and the texture read, the one value that every renderer consumes (`Scene`).
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "math/vec.h"
#include "models/registry.h"
#include "scene/image.h"
#include "scene/triangle_mesh.h"

namespace lumaknot {

/// The tool whose knot it is: how vertices, normals, texture coordinates and triangles are built
/// and ordered, and the defaults of the numbers.
enum class Convention {
  kLumaknot,  ///< exact rings, links of gcd(p, q) components, seams duplicated both ways
  kThree,     ///< three.js's TorusKnotGeometry
  kBabylon,   ///< Babylon.js's CreateTorusKnotVertexData
  kBlender,   ///< lumaknot's tube about the curve of Blender's add-on "Torus Knot Plus"
};

/// How the rings of the tube are rotated about its centre line.
enum class FrameRule {
  kRotationMinimizing,  ///< exactly, by the integral of the geodesic torsion
  kDoubleReflection,    ///< by Wang, Juettler, Zheng and Liu's steps from ring to ring, 2008
  kFrenet,              ///< the principal normal; undefined where the curvature is zero
  kFixedUp,             ///< +Z projected; undefined where the centre line is vertical
  kThree,               ///< as three.js: planes through a point a little farther on
};

/// The quantity that texture coordinates along the knot are proportional to.
enum class Unwrap { kParameter, kArcLength };

/// A round tube swept along a (p,q) torus knot about +Z or, when p and q have a common divisor,
/// along the link with that many components. Lengths in scene units.
struct KnotSpec {
  Convention convention = Convention::kLumaknot;
  int p = 2;                  ///< turns about the axis
  int q = 3;                  ///< turns through the hole; not both zero
  double major_radius = 1.0;  ///< from the axis to the centre of the torus tube, > 0
  double minor_radius = 0.4;  ///< from that centre to the knot, > 0
  double tube_radius = 0.18;  ///< of the tube swept along the knot, > 0, < major_radius
  int segments = 768;         ///< along each component, >= 3
  int sides = 40;             ///< around the tube, >= 3
  int repeat_u = 1;           ///< texture tiles along each component, >= 1
  int repeat_v = 1;           ///< texture tiles around the tube, >= 1
  FrameRule frames = FrameRule::kRotationMinimizing;
  Unwrap unwrap = Unwrap::kArcLength;
};

/// A triangle mesh in a file.
struct MeshFile {
  std::string path;
};

using MeshSpec = std::variant<KnotSpec, MeshFile>;

/// The built-in procedural brick wall, 512 x 512.
struct Bricks {};

/// An image file, its values used as they are.
struct TextureFile {
  std::string path;
};

/// One colour, components in [0, 1].
struct PlainColor {
  Vec3d rgb{0.7, 0.7, 0.7};
};

using TextureSpec = std::variant<Bricks, TextureFile, PlainColor>;

/// A pinhole camera.
struct Camera {
  Vec3d position{0.0, -3.6, 2.4};
  Vec3d target{0.0, 0.0, 0.0};
  Vec3d up{0.0, 0.0, 1.0};  ///< not along the line of sight
  double fov_degrees = 45;  ///< vertical field of view, (0, 180)
};

/// How a light weakens at distance d: 1 / (constant + linear d + quadratic d^2). Not all zero.
struct Falloff {
  double constant = 1, linear = 0, quadratic = 0;  ///< each >= 0
};

/// Properties of every light. A coloured light acts on each channel in space rgb, and with the
/// brightness of its colour (white: 1) in a space where light acts on brightness alone.
struct LightColor {
  Vec3d rgb{1, 1, 1};    ///< components in [0, 1]
  double intensity = 1;  ///< >= 0
};

/// A lamp that shines in all directions.
struct PointLight {
  Vec3d position{-1.5, -3.0, 3.5};
  LightColor color;
  Falloff falloff;
};

/// A lamp so far away that its rays are parallel and do not weaken.
struct DirectionalLight {
  Vec3d direction{0, 0, -1};  ///< in which it shines; not zero
  LightColor color;
};

/// A lamp with a cone: full within `inner_degrees` of its axis, none beyond `outer_degrees`, in
/// between smoothstep of the angle's cosine.
struct SpotLight {
  Vec3d position{-1.5, -3.0, 3.5};
  Vec3d direction{1.5, 3.0, -3.5};  ///< in which it shines; not zero
  double inner_degrees = 15, outer_degrees = 25;
  LightColor color;
  Falloff falloff;
};

using Light = std::variant<PointLight, DirectionalLight, SpotLight>;

/// Where light acts: on every channel (eq. 3), or on the brightness axis of a space alone (6-8).
enum class Space { kRgb, kYiq, kYuv601, kYuv709, kCielab, kCieluv, kDin99, kAtd95 };

/// Whether the space is a matrix away from r'g'b', with equal chroma for all greys.
constexpr bool is_linear(Space space) {
  return space == Space::kYiq || space == Space::kYuv601 || space == Space::kYuv709;
}

/// How the colour is converted to a space of brightness and chroma, and back.
enum class Form {
  kMatrices,   ///< into the space and back, as the paper's Table 1
  kCollapsed,  ///< F = T + (Y_F - Y_T): linear spaces only
  kBaked,      ///< the texture holds the space's axes: linear spaces only
};

enum class Clamp {
  kFree,
  kTable1
};  ///< no clamp (eq. 3, 6) or Table 1's: saturate(L_D), then
    ///< saturate(L_D + L_A), then the colour
enum class NormalUse { kUnit, kInterpolated };  ///< renormalised per pixel, or as Table 1 uses it

/// The treatment of colours outside [0, 1].
enum class Gamut {
  kFree,    ///< they stay
  kClamp,   ///< each channel is limited
  kChroma,  ///< mixed with the grey of their brightness until they fit: the hue is kept
};

/// Whether there are highlights where n.l <= 0.
enum class Highlights { kFree, kGated };

/// Where the light is computed: per pixel (Phong shading), or per vertex and interpolated
/// (Gouraud).
enum class ShadingFrequency { kPixel, kVertex };

/// How the surface reflects the light.
struct Material {
  Model model = Model::kPhong;
  Space space = Space::kRgb;
  Form form = Form::kMatrices;
  ModelParameters<double> parameters;  ///< those that `model` does not have are not read
  double diffuse = 1;                  ///< weight of L_D, >= 0
  double specular = 1;                 ///< weight of L_S, >= 0
  Vec3d ambient_color{1, 1, 1}, diffuse_color{1, 1, 1}, specular_color{1, 1, 1};  ///< m_a, m_d, m_s
  Vec3d emissive{0, 0, 0};  ///< m_e, the light that the surface emits
  double luma_offset = 0;   ///< added to Y_F; Table 1: -0.1. Zero in space rgb
  Clamp clamp = Clamp::kFree;
  Gamut gamut = Gamut::kFree;
  NormalUse normal = NormalUse::kUnit;
  Highlights highlights = Highlights::kFree;
  ShadingFrequency rate = ShadingFrequency::kPixel;
};

/// Size in pixels, and samples x samples evenly spaced samples per pixel (1: one at its centre).
struct ImageSpec {
  int width = 720, height = 720;
  int samples = 1;
};

/// The part of a scene that does not depend on whether its mesh and texture are in memory.
struct View {
  Camera camera;
  std::vector<Light> lights{PointLight{}};
  double ambient = 0.1;  ///< L_A, >= 0
  Vec3d ambient_color{1, 1, 1};
  Material material;
  ImageSpec image;
};

/// A scene by names and numbers, as given by scene.json.
struct SceneSpec {
  MeshSpec mesh;
  TextureSpec texture;
  View view;
};

/// The texture in memory: an image, or one colour for the whole surface.
using Texture = std::variant<TextureImage, Vec3d>;

/// A scene in memory, ready for every renderer.
struct Scene {
  TriangleMesh mesh;
  Texture texture;
  View view;
};

/// The near depth, in front of which nothing is drawn: a thousandth of the distance to the target.
inline double near_depth(const Camera& camera) {
  return 1e-3 * length(camera.position - camera.target);
}

/// The camera's axes: unit, right-handed; it looks along -back.
struct CameraFrame {
  Vec3d right, up, back;
};

/// The axes of `camera`, whose line of sight and `up` must not be parallel.
inline CameraFrame camera_frame(const Camera& camera) {
  const Vec3d back = normalize(camera.position - camera.target);
  const Vec3d right = normalize(cross(camera.up, back));
  return {right, cross(back, right), back};
}

}  // namespace lumaknot
