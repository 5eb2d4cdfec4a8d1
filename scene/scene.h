/// What a picture is made of: the description (`SceneSpec`, as in scene.json) and, with the mesh
/// built and the texture read, the one value that every renderer consumes (`Scene`).
#pragma once

#include <string>
#include <variant>

#include "scene/image.h"
#include "scene/triangle_mesh.h"
#include "scene/vec.h"

namespace lumaknot {

/// A round tube swept along a (p,q) torus knot about +Z. Lengths in scene units.
struct KnotSpec {
  int p = 2;                    ///< turns about the axis; coprime to q
  int q = 3;                    ///< turns through the hole
  double ring_radius = 1.0;     ///< from the axis to the centre of the torus tube, > 0
  double winding_radius = 0.4;  ///< from that centre to the knot, > 0
  double tube_radius = 0.18;    ///< of the tube swept along the knot, > 0
  int segments = 768;           ///< along the knot, >= 3
  int sides = 40;               ///< around the tube, >= 3
  int repeat_u = 1;             ///< texture tiles along the knot, >= 1
  int repeat_v = 1;             ///< texture tiles around the tube, >= 1
};

/// A triangle mesh in a file (.obj, .ply, .off, .stl).
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

/// A white point light of strength one that does not fall off with distance.
struct PointLight {
  Vec3d position{-1.5, -3.0, 3.5};
};

enum class Model { kPhong };      ///< paper eq. 1 and 2
enum class Space { kRgb, kYiq };  ///< where light acts: every channel (eq. 3) or luma alone (6-8)
enum class Clamp {
  kFree,
  kTable1
};  ///< no clamp (eq. 3, 6) or Table 1's: saturate(L_D), then
    ///< saturate(L_D + L_A), then the colour
enum class NormalUse { kUnit, kInterpolated };  ///< renormalised a pixel, or as Table 1 uses it

/// How the surface answers the light.
struct Material {
  Model model = Model::kPhong;
  Space space = Space::kRgb;
  double shininess = 55;   ///< k of eq. 2, >= 0
  double diffuse = 1;      ///< weight of L_D, >= 0
  double specular = 1;     ///< weight of L_S, >= 0
  double luma_offset = 0;  ///< added to Y_F; Table 1: -0.1. Zero outside a luma space
  Clamp clamp = Clamp::kFree;
  NormalUse normal = NormalUse::kUnit;
};

/// Size in pixels, and samples x samples evenly spaced samples a pixel (1: one at its centre).
struct ImageSpec {
  int width = 720, height = 720;
  int samples = 1;
};

/// What a scene shares whether or not its mesh and texture are in memory.
struct View {
  Camera camera;
  PointLight light;
  double ambient = 0.1;  ///< L_A, >= 0
  Material material;
  ImageSpec image;
};

/// A scene by names and numbers, as scene.json tells it.
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

/// Nothing nearer to the eye than this depth is drawn: a thousandth of the distance to the target.
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
