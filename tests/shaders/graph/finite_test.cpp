// No valid scene gives a colour that is not a number.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/shaders/formulas/random_surface.h"
#include "tests/shaders/languages/every_shot.h"
#include "tests/shaders/spaces/cases.h"

namespace lumaknot {
namespace {

/// A surface and where eye and lamp are.
struct Place {
  std::string name;
  SurfacePoint<double> point;
  Vec3d eye, lamp;
};

std::vector<Place> edge_places() {
  const Vec3d o{0.5, -0.25, 1}, n{0, 0, 1}, x{1, 0, 0}, slanted = normalize(Vec3d{1, 2, 2});
  return {{"no normal", {o, {0, 0, 0}}, o + n, o + slanted},
          {"eye at the surface", {o, n}, o, o + slanted},
          {"lamp at the surface", {o, n}, o + slanted, o},
          {"both at the surface", {o, n}, o, o},
          {"nothing but a point", {o, {0, 0, 0}}, o, o},
          {"grazing lamp", {o, n}, o + slanted, o + x},
          {"grazing eye", {o, n}, o + x, o + slanted},
          {"both grazing", {o, n}, o + x, o + Vec3d{0, 1, 0}},
          {"opposite, both grazing", {o, n}, o + x, o - x},
          {"opposite, lamp in front", {o, n}, o - n, o + n},
          {"opposite, lamp behind", {o, n}, o + slanted, o - slanted},
          {"mirror", {o, n}, o + Vec3d{0.6, 0, 0.8}, o + Vec3d{-0.6, 0, 0.8}},
          {"all along the normal", {o, n}, o + n, o + n},
          {"both behind", {o, n}, o - n, o - slanted},
          {"short normal", {o, n * 1e-3}, o + n, o + slanted},
          {"lamp and eye near", {o, n}, o + n * 1e-6, o + slanted * 1e-6}};
}

std::vector<Place> random_places() {
  RandomSurface random;
  std::vector<Place> places;
  for (int i = 0; i < 20; ++i) {
    const SurfacePoint<double> point = random.point();
    const Vec3d eye = random.vector(-2, 2);
    places.push_back({"random", point, eye, random.vector(-2, 2)});
  }
  return places;
}

/// `m` with the numbers of its model at the ends of their ranges.
std::vector<Material> edge_materials(const Material& m) {
  std::vector<Material> result{m};
  const auto add = [&](auto term, auto...) {
    for (const Parameter& p : term.kParameters) {
      for (const double value : {p.range.min, p.value, std::min(p.range.max, 1e6)}) {
        result.push_back(m);
        result.back().parameters.at(kNamedParameters.index_of(p.name)) = value;
      }
    }
  };
  with_diffuse(m.model, m.parameters, add);
  with_highlight(m.model, m.parameters, add);
  return result;
}

View view_of(const Place& place) {
  View view;
  view.camera.position = place.eye;
  const Vec3d down{0, 0, -1};
  view.lights = {PointLight{place.lamp, {}, {1, 0.5, 0.25}},
                 SpotLight{place.lamp, down, 0, 0.1, {}, {0.1, 0, 0}},
                 DirectionalLight{down, {{1, 0.5, 0.2}, 1}}};
  return view;
}

template <class S>
Vec3d color_at(const Place& place, const Vec3d& texture, const Shot& shot) {
  const auto lighting = lighting_of<S>(view_of(place), shot.material);
  const SurfacePoint<S> point{narrowed<S>(place.point.position), narrowed<S>(place.point.normal)};
  return widened(
      stage_color<S>(point, narrowed<S>(texture_value(texture, shot.material)), lighting, shot));
}

/// The cases in which a formula gives a colour that is not a number.
template <class S>
std::set<std::string> infinite_places(const std::vector<Place>& places) {
  std::set<std::string> found;
  for (const Shot& shot : final_shots()) {
    for (const Material& m : edge_materials(shot.material)) {
      for (const Place& place : places) {
        for (const Vec3d& texture : {Vec3d{0.7, 0.4, 0.2}, Vec3d{0, 0, 0}, Vec3d{0, 0, 1}}) {
          const Vec3d color = color_at<S>(place, texture, {shot.name, Stage::kFinal, m});
          if (!is_finite(color)) found.insert(formula_name(m) + ": " + place.name);
        }
      }
    }
  }
  return found;
}

const std::set<std::string> kNowhere;

TEST(Finite, every_formula_at_every_edge_in_double) {
  EXPECT_EQ(infinite_places<double>(edge_places()), kNowhere);
}

TEST(Finite, every_formula_at_every_edge_in_float) {
  EXPECT_EQ(infinite_places<float>(edge_places()), kNowhere);
}

TEST(Finite, every_formula_on_random_surfaces_in_double) {
  EXPECT_EQ(infinite_places<double>(random_places()), kNowhere);
}

TEST(Finite, every_formula_on_random_surfaces_in_float) {
  EXPECT_EQ(infinite_places<float>(random_places()), kNowhere);
}

}  // namespace
}  // namespace lumaknot
