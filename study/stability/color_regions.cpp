// Colours that leave the gamut, and the conversion to YIQ and back.
#include <algorithm>
#include <array>
#include <numbers>

#include "math/angle.h"
#include "scene/fields.h"
#include "shaders/spaces/matrix3.h"
#include "study/stability/regions.h"
#include "study/stability/test_scenes.h"

namespace lumaknot::stability {
namespace {

/// The colours of the RGB cube in steps of a fifth.
const std::vector<Vec3d>& cube() {
  static const std::vector<Vec3d> kCube = [] {
    std::vector<Vec3d> colors;
    colors.reserve(216);
    for (int i = 0; i < 216; ++i) {
      const int red = i % 6, green = i / 6 % 6, blue = i / 36;
      colors.push_back({red / 5.0, green / 5.0, blue / 5.0});
    }
    return colors;
  }();
  return kCube;
}

/// r'g'b' across the grey axis: its angle is the hue, its length the chroma.
struct Chroma {
  double x, y;
  double size() const { return std::hypot(x, y); }
};

Chroma chroma_of(const Vec3d& rgb) {
  return {rgb.x - (rgb.y + rgb.z) / 2, (rgb.y - rgb.z) * std::numbers::sqrt3 / 2};
}

double hue_error(const Vec3d& before, const Vec3d& after) {
  const Chroma a = chroma_of(before), b = chroma_of(after);
  constexpr double kGrey = 1e-3;  // too little to have a hue
  if (a.size() < kGrey || b.size() < kGrey) return 0;
  return std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y)) * kDegrees;
}

Vec3d lit(const Vec3d& rgb, double light, const Material& m) {
  Lighting<double> lighting = lighting_of<double>(View{}, m);
  lighting.ambient = grey(0.0);
  return lit_color<double>(rgb, {grey(light), grey(0.0)}, lighting, m);
}

/// The mean of `value(before, after)` over the cube's colours.
template <class F>
double mean_over_cube(double light, const Material& m, F value) {
  double sum = 0;
  for (const Vec3d& rgb : cube()) sum += value(rgb, lit(rgb, light, m));
  return sum / double(cube().size());
}

bool is_outside(const Vec3d& c) {
  constexpr double kRounding = 1e-6;  // of M and W
  return std::min({c.x, c.y, c.z}) < -kRounding || largest_component(c) > 1 + kRounding;
}

/// The chroma beyond what the eye should see: the colour's own times the light, as from a surface.
double chroma_excess(const Vec3d& before, const Vec3d& after, double light) {
  return chroma_of(after).size() - chroma_of(before).size() * light;
}

Material in_space(Space space, Gamut gamut) {
  Material m;
  m.space = space;
  m.gamut = gamut;
  return m;
}

/// The knot in even light.
Scene evenly_lit(double light, const Material& material) {
  Scene scene = knot_scene(material);
  scene.view.lights.clear();
  scene.view.ambient = light;
  return scene;
}

Region clamp_of(Space space, double from, double to) {
  const Material clamped = in_space(space, Gamut::kClamp), kept = in_space(space, Gamut::kChroma);
  const Material free = in_space(space, Gamut::kFree);
  const auto hue = [free](const Material& m) {
    return [m, free](double light) {
      return mean_over_cube(light, m, [&](const Vec3d& rgb, const Vec3d& c) {
        return hue_error(lit(rgb, light, free), c);
      });
    };
  };
  const auto picture = [](const Material& m) {
    return [m](double light, int side) { return draw(evenly_lit(light, m), side); };
  };
  Region region;
  region.group = "Gamut";
  region.remedy =
      "mix with the grey of the same brightness until it fits: material.gamut "
      "\"chroma\" keeps the hue";
  region.sweep = {"light L_A + L_D", from, to};
  region.measured = "mean turn of the hue by the clamp over the RGB cube, degrees";
  region.limit = 3;
  region.error = hue(clamped);
  region.guarded = hue(kept);
  region.also = {
      {"share of the cube outside the gamut",
       [free](double light) {
         return mean_over_cube(
             light, free, [](const Vec3d&, const Vec3d& c) { return is_outside(c) ? 1.0 : 0.0; });
       }},
      {"mean hue error against the texture, degrees",
       [clamped](double light) { return mean_over_cube(light, clamped, hue_error); }},
      {"mean chroma above the light's share of the texture's",
       [clamped](double light) {
         return mean_over_cube(light, clamped, [light](const Vec3d& rgb, const Vec3d& c) {
           return chroma_excess(rgb, c, light);
         });
       }},
      {"share of the bricks' pixels outside the gamut", [free](double light) {
         const Scene scene = evenly_lit(light, free);
         return share_of(scene, 64, [color = color_in<double>(scene)](const Fragment& f) {
           return is_outside(color(f));
         });
       }}};
  region.sketch = picture(clamped);
  region.guarded_sketch = picture(kept);
  return region;
}

std::string name_of(Space space) { return std::string(kSpaceNames[std::size_t(space)]); }

Region dark_clamp(Space space) {
  Region region = clamp_of(space, 1, 0);
  region.name = "clamp-dark-" + name_of(space);
  region.method = "light on the brightness of " + name_of(space) + " alone, then the clamp";
  region.reason =
      "the dark side keeps the full chroma of the texture, which so dark no colour of the cube "
      "has: "
      "channels below 0 are cut off and the hue turns";
  if (space == Space::kCieluv) region.reason += "; at 0 all is black, which has no hue";
  region.shown_fails = 0.1;
  region.shown_holds = 1;
  return region;
}

Region bright_clamp(Space space) {
  Region region = clamp_of(space, 1, 4);
  region.name = "clamp-bright-" + name_of(space);
  region.method = "light above 1 in " + name_of(space) + ", then the clamp";
  region.reason =
      "channels above 1 are cut off one after the other, and the hue turns to the next "
      "corner of the cube";
  if (space != Space::kRgb) {
    region.reason += "; in light brighter still most become white, which has no hue";
  }
  region.shown_fails = 2.5;
  region.shown_holds = 1;
  return region;
}

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  const Matrix3 t = {{{b.rows[0].x, b.rows[1].x, b.rows[2].x},
                      {b.rows[0].y, b.rows[1].y, b.rows[2].y},
                      {b.rows[0].z, b.rows[1].z, b.rows[2].z}}};
  const auto row = [&](const Vec3d& r) {
    return Vec3d{dot(r, t.rows[0]), dot(r, t.rows[1]), dot(r, t.rows[2])};
  };
  return {{row(a.rows[0]), row(a.rows[1]), row(a.rows[2])}};
}

/// W M as in the formulas.
Matrix3 round_trip() {
  const auto column = [](const Vec3d& e) { return rgb_from_yiq(yiq_from_rgb<double>(e)); };
  const Vec3d x = column({1, 0, 0}), y = column({0, 1, 0}), z = column({0, 0, 1});
  return {{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}};
}

/// (W M)^n.
Matrix3 passes(long long n) {
  Matrix3 result{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, power = round_trip();
  for (; n > 0; n /= 2) {
    if (n % 2) result = product(result, power);
    power = product(power, power);
  }
  return result;
}

Region yiq_round_trip() {
  Region region;
  region.name = "yiq-round-trip";
  region.group = "Gamut";
  region.method = "YIQ and back by the paper's M and W, pass after pass, in double";
  region.reason = "M and W have eight printed digits and are inverse to each other to 1e-7";
  region.remedy = "the collapsed form F = T + (Y_F - Y_T), which goes through no matrix";
  region.sweep = {"passes", 1, 1e8, true, true};
  region.measured = "largest difference of a channel from what went in, of full scale";
  region.limit = 1.0 / 255;
  region.error = [](double n) {
    const Matrix3 all = passes(std::llround(n));
    double largest = 0;
    for (const Vec3d& rgb : cube()) {
      const Vec3d d = transform<double>(all, rgb) - rgb;
      largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    return largest;
  };
  region.guarded = [](double) {
    Material m = in_space(Space::kYiq, Gamut::kFree);
    m.form = Form::kCollapsed;
    double largest = 0;
    for (const Vec3d& rgb : cube()) {
      const Vec3d d = lit(rgb, 1, m) - rgb;  // equal in every pass
      largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    return largest;
  };
  region.sketch = [](double n, int side) {
    const Scene scene = knot_scene(Material{});
    return shade_each(scene, side, [&, all = passes(std::llround(n))](const Fragment& f) {
      return transform<double>(all, texture_color(scene.texture, f.uv));
    });
  };
  region.shown_holds = 1;
  region.shown_fails = 3e6;
  return region;
}

}  // namespace

std::vector<Region> color_regions() {
  std::vector<Region> regions;
  for (const Space space : {Space::kYiq, Space::kYuv601, Space::kYuv709, Space::kCielab,
                            Space::kCieluv, Space::kDin99, Space::kAtd95}) {
    regions.push_back(dark_clamp(space));
  }
  for (const Space space : {Space::kRgb, Space::kYiq}) regions.push_back(bright_clamp(space));
  regions.push_back(yiq_round_trip());
  return regions;
}

}  // namespace lumaknot::stability
