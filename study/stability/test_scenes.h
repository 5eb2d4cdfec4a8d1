/// Small scenes and pictures that regions share.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "meshgen/spine.h"
#include "render/reference.h"
#include "render/texture.h"
#include "scene/spec.h"
#include "shaders/formulas/lighting.h"

namespace lumaknot::stability {

/// The built-in knot on a grid for small pictures: 384 x 32.
KnotSpec sketch_knot();

/// A knot with Figure 1's bricks, camera and light in front.
Scene knot_scene(const KnotSpec& knot, const Material& material);
inline Scene knot_scene(const Material& material) { return knot_scene(sketch_knot(), material); }

/// The default material with the formula of that name.
Material formula(std::string_view name);

/// `scene` drawn by the reference at side x side pixels.
Image draw(Scene scene, int side);

using FragmentColor = std::function<Vec3d(const Fragment&)>;

/// side x side pixels, each with the colour that its centre sees; black if it sees nothing.
Image shade_each(Scene scene, int side, const FragmentColor& color);

/// The share of covered pixels for which `answer` is true; 0 if none is covered.
double share_of(Scene scene, int side, const std::function<bool(const Fragment&)>& answer);

/// The root mean square of the difference of the colours of two images of equal size.
double rms_difference(const Image& a, const Image& b);

/// `scene`'s final shot with arithmetic in S, every length first multiplied by `scale`.
template <class S>
FragmentColor color_in(const Scene& scene, double scale = 1) {
  View view = scene.view;
  view.camera.position = view.camera.position * scale;
  for (Light& light : view.lights) {
    if (auto* point = std::get_if<PointLight>(&light)) point->position = point->position * scale;
  }
  const Shot shot{"", Stage::kFinal, view.material};
  return [&scene, scale, shot, lighting = lighting_of<S>(view, view.material)](const Fragment& f) {
    const Vec3d texture = texture_value(texture_color(scene.texture, f.uv), shot.material);
    const Vec<S> color =
        stage_color<S>({constant_vec<S>(f.position * scale), constant_vec<S>(f.normal)},
                       constant_vec<S>(texture), lighting, shot);
    return Vec3d{double(color.x), double(color.y), double(color.z)};
  };
}

/// The largest difference of a channel between two colourings of `scene` at side x side pixels; not
/// a number if one of them is not.
double largest_difference(const Scene& scene, int side, const FragmentColor& a,
                          const FragmentColor& b);

/// A tube of one component with its rings at `frames`; the last is the seam's other side.
TriangleMesh tube_of(const std::vector<RingFrame>& frames, double tube_radius, int sides);

}  // namespace lumaknot::stability
