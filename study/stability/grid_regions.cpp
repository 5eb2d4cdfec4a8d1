// Tubes, turns and grids.
#include <fmt/format.h>

#include <algorithm>

#include "meshgen/clearance.h"
#include "study/stability/regions.h"
#include "study/stability/test_scenes.h"
#include "study/stability/tube_measures.h"

namespace lumaknot::stability {
namespace {

KnotSpec with_tube(double radius) {
  KnotSpec knot = sketch_knot();
  knot.tube_radius = radius;
  return knot;
}

Region tube_clearance() {
  const auto cleared = [](double radius) {
    const KnotSpec knot = with_tube(radius);
    return with_tube(std::min(radius, 0.999 * clearance(components(knot)).radius));
  };
  Region region;
  region.name = "tube-clearance";
  region.group = "Tubes and grids";
  region.method = "a tube as thick as one likes";
  region.reason =
      "beyond the clearance, half of the least distance of two strands or the least radius of "
      "curvature, the surface passes through itself; the clearance is known to 1e-6 of itself";
  region.remedy =
      "keep the radius below the clearance, which `lumaknot mesh --measure` reports and above "
      "which `lumaknot mesh --strict` refuses";
  region.sweep = {"tube radius, R = 1, w = 0.4", 0.05, 0.45};
  region.measured = "how deep the tube reaches into itself, share of its radius (tolerance 1e-6)";
  region.limit = 1e-6;
  region.also = {{"radius / clearance",
                  [](double r) { return r / clearance(components(with_tube(r))).radius; }}};
  region.error = [](double r) { return overlap(with_tube(r)); };
  region.guarded = [cleared](double r) { return overlap(cleared(r)); };
  region.sketch = [](double r, int side) {
    return draw(knot_scene(with_tube(r), Material{}), side);
  };
  region.guarded_sketch = [cleared](double r, int side) {
    return draw(knot_scene(cleared(r), Material{}), side);
  };
  region.guarded_shows = [cleared](double r) {
    return fmt::format("radius {:.4g}", cleared(r).tube_radius);
  };
  region.shown_holds = 0.2;
  return region;
}

KnotSpec winding(int q, int segments, double tube_radius) {
  KnotSpec knot = sketch_knot();
  knot.q = q;
  knot.segments = segments;
  knot.tube_radius = tube_radius;
  return knot;
}

Region strands_touch() {
  const auto knot = [](double q) { return winding(int(q), 1536, 0.1); };
  const auto room = [](const KnotSpec& k) { return clearance(components(k)).radius; };
  const auto fitted = [knot, room](double q) {
    KnotSpec thin = knot(q);
    thin.tube_radius = std::min(thin.tube_radius, 0.9 * room(thin));
    return thin;
  };
  Region region;
  region.name = "strands-touch";
  region.group = "Tubes and grids";
  region.method = "one tube radius, 0.1, for every (2,q), q to 100";
  region.reason = "strands that wind more often lie nearer to each other, as 1 / q";
  region.remedy =
      "a radius below the knot's own clearance, which `lumaknot mesh --measure` reports";
  region.sweep = {"windings q of the (2,q) knot or link", 1, 100, false, true};
  region.measured = "tube radius / clearance";
  region.limit = 1;
  region.error = [knot, room](double q) { return 0.1 / room(knot(q)); };
  region.guarded = [fitted, room](double q) { return fitted(q).tube_radius / room(fitted(q)); };
  region.sketch = [knot](double q, int side) {
    return draw(knot_scene(knot(q), Material{}), side);
  };
  region.guarded_sketch = [fitted](double q, int side) {
    return draw(knot_scene(fitted(q), Material{}), side);
  };
  region.guarded_shows = [fitted](double q) {
    return fmt::format("{}, radius {:.3g}", q, fitted(q).tube_radius);
  };
  region.shown_holds = 3;
  region.shown_fails = 25;
  return region;
}

constexpr double kChordLimit = 0.1;

/// A region of grids that are too coarse, its knot given by the swept value.
Region coarse(const std::function<KnotSpec(double)>& knot,
              const std::function<KnotSpec(double)>& fine) {
  Region region;
  region.group = "Tubes and grids";
  region.measured = "largest distance of the triangles from the exact tube, share of its radius";
  region.limit = kChordLimit;
  region.error = [knot](double x) { return chord_share(knot(x)); };
  region.guarded = [fine](double x) { return chord_share(fine(x)); };
  region.sketch = [knot](double x, int side) {
    return draw(knot_scene(knot(x), Material{}), side);
  };
  region.guarded_sketch = [fine](double x, int side) {
    return draw(knot_scene(fine(x), Material{}), side);
  };
  region.guarded_shows = [fine](double x) {
    return fmt::format("{} x {} grid", fine(x).segments, fine(x).sides);
  };
  return region;
}

/// Windings in one loop, for any number of them.
KnotSpec unknot(int q, int segments) {
  KnotSpec knot = winding(q, segments, 0.03);
  knot.p = 1;
  return knot;
}

Region many_turns() {
  Region region = coarse([](double q) { return unknot(int(q), 384); },
                         [](double q) { return unknot(int(q), 384 + 128 * int(q)); });
  region.name = "many-turns";
  region.method = "384 segments for every (1,q), q to 100";
  region.reason =
      "each winding gets 384 / q chords of a circle of radius w, whose sagitta grows "
      "as q^2";
  region.remedy = "segments in proportion to the turns, or `lumaknot mesh --max-error`";
  region.sweep = {"windings q of the (1,q) knot", 1, 100, false, true};
  region.shown_holds = 3;
  region.shown_fails = 71;
  return region;
}

KnotSpec on_grid(double segments, double sides) {
  KnotSpec knot = sketch_knot();
  knot.segments = int(segments);
  knot.sides = int(sides);
  return knot;
}

Region few_segments() {
  Region region =
      coarse([](double n) { return on_grid(n, 40); }, [](double) { return on_grid(384, 40); });
  region.name = "few-segments";
  region.method = "few segments along the knot";
  region.reason = "chords leave the bend of the centre line, as 1 / segments^2";
  region.remedy = "`lumaknot mesh --max-error`: the leanest grid within a distance";
  region.sweep = {"segments", 768, 3, true, true};
  region.shown_holds = 768;
  region.shown_fails = 13;
  return region;
}

Region few_sides() {
  Region region =
      coarse([](double n) { return on_grid(384, n); }, [](double) { return on_grid(384, 40); });
  region.name = "few-sides";
  region.method = "few sides around the tube";
  region.reason = "a polygon's sides lie r (1 - cos(pi / sides)) inside its circle";
  region.remedy = "`lumaknot mesh --max-error`: the leanest grid within a distance";
  region.sweep = {"sides", 40, 3, false, true};
  region.shown_holds = 40;
  region.shown_fails = 4;
  return region;
}

/// The share of pixels whose interpolated normal points away from the eye.
double turned_away(const Scene& scene) {
  return share_of(scene, 96, [&](const Fragment& f) {
    return dot(f.normal, scene.view.camera.position - f.position) < 0;
  });
}

/// Pixels whose normal points away from the eye, in red, over the picture.
Image draw_turned(const Scene& scene, int side) {
  return shade_each(scene, side, [&, color = color_in<double>(scene)](const Fragment& f) {
    const bool away = dot(f.normal, scene.view.camera.position - f.position) < 0;
    return away ? Vec3d{1, 0, 0} : color(f);
  });
}

Region grazing_normals() {
  const auto scene = [](double sides) { return knot_scene(on_grid(384, sides), Material{}); };
  Region region;
  region.name = "grazing-normals";
  region.group = "Tubes and grids";
  region.method = "interpolated normals at grazing views";
  region.reason =
      "flat triangles end before the round tube does: near silhouettes they show the eye a normal "
      "that points away from it, n.v < 0, on which every formula with n.v is undefined";
  region.remedy = "more sides; formulas that limit n.v from below, as ours do";
  region.sweep = {"sides", 64, 3, true, true};
  region.measured = "share of pixels with n.v < 0 (red)";
  region.limit = 0.01;
  region.error = [scene](double n) { return turned_away(scene(n)); };
  region.guarded = [scene](double) { return turned_away(scene(64)); };
  region.sketch = [scene](double n, int side) { return draw_turned(scene(n), side); };
  region.guarded_sketch = [scene](double, int side) { return draw_turned(scene(64), side); };
  region.guarded_shows = [](double) { return "64 sides"; };
  region.shown_fails = 6;
  region.shown_holds = 64;
  return region;
}

/// A region in which a material on few sides is compared with another on the same mesh.
Region shading_on_sides(const Material& method, const Material& remedy) {
  const auto scene = [](double sides, const Material& m) {
    return knot_scene(on_grid(sides * 6, sides), m);
  };
  Region region;
  region.group = "Tubes and grids";
  region.sweep = {"sides (six times as many segments)", 96, 3, true, true};
  region.limit = 0.02;
  region.measured = "RMS difference from the picture with the remedy, of full scale";
  region.error = [=](double n) {
    return rms_difference(draw(scene(n, method), 96), draw(scene(n, remedy), 96));
  };
  region.sketch = [=](double n, int side) { return draw(scene(n, method), side); };
  region.guarded_sketch = [=](double n, int side) { return draw(scene(n, remedy), side); };
  region.shown_fails = 8;
  region.shown_holds = 96;
  return region;
}

Region unnormalised_normal() {
  Material interpolated;
  interpolated.normal = NormalUse::kInterpolated;
  Region region = shading_on_sides(interpolated, Material{});
  region.name = "unnormalised-normal";
  region.method = "Table 1's interpolated normal, not renormalised";
  region.reason =
      "between vertices the normal is shorter than one, and R = 2 (n.L) n - L is no mirror "
      "direction: highlights move and dim between vertices";
  region.remedy = "renormalise in every pixel (material.normal \"unit\")";
  region.shown_fails = 5;
  return region;
}

Region light_at_vertices() {
  Material gouraud;
  gouraud.rate = ShadingFrequency::kVertex;
  Region region = shading_on_sides(gouraud, Material{});
  region.name = "light-at-vertices";
  region.method = "light computed at vertices and interpolated (Gouraud)";
  region.reason =
      "a highlight that lies between vertices is lost, one on a vertex is smeared over "
      "its triangles";
  region.remedy = "light per pixel (material.rate \"pixel\")";
  return region;
}

}  // namespace

std::vector<Region> grid_regions() {
  return {tube_clearance(), strands_touch(),   many_turns(),          few_segments(),
          few_sides(),      grazing_normals(), unnormalised_normal(), light_at_vertices()};
}

}  // namespace lumaknot::stability
