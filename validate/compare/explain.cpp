#include "validate/compare/explain.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "render/projection.h"
#include "render/triangle.h"

namespace lumaknot::validate {
namespace {

Vec3d normal_of(const TriangleMesh& mesh, const Fragment& fragment) {
  return triangle_normal(mesh, mesh.triangles[std::size_t(fragment.triangle)]);
}

bool one_sheet(const TriangleMesh& mesh, const Fragment& a, const Fragment& b, double tolerance) {
  const Vec3d apart = b.position - a.position;
  return std::abs(dot(normal_of(mesh, a), apart)) <= tolerance ||
         std::abs(dot(normal_of(mesh, b), apart)) <= tolerance;
}

bool at_silhouette(const Scene& scene, const Grid<Fragment>& fragments, double pixel_width, int x,
                   int y) {
  const Fragment& here = fragments.at(x, y);
  for (int ny = std::max(0, y - 1); ny <= std::min(fragments.height - 1, y + 1); ++ny) {
    for (int nx = std::max(0, x - 1); nx <= std::min(fragments.width - 1, x + 1); ++nx) {
      const Fragment& there = fragments.at(nx, ny);
      if (!there.covered()) return true;
      if (!one_sheet(scene.mesh, here, there, 2 * pixel_width * here.depth)) return true;
    }
  }
  return false;
}

constexpr Habits kAllHabits[] = {{false, false}, {false, true}, {true, false}, {true, true}};

Shot gated(Shot shot) {
  shot.material.highlights = Highlights::kGated;
  return shot;
}

bool agrees(const Vec3d& ours, const TheirPixel& theirs) {
  return channel_error(ours, theirs.color, theirs.limited) <= theirs.tolerance;
}

/// Whether each channel of theirs is between the smallest and the largest of `colors`.
bool lies_among(const std::vector<Vec3d>& colors, const TheirPixel& theirs) {
  const auto shown = [&](double v) { return theirs.limited ? std::clamp(v, 0.0, 1.0) : v; };
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto of = [&](const Vec3d& c) { return shown(components(c)[channel]); };
    const auto [low, high] = std::ranges::minmax(colors, {}, of);
    const double value = of(to_vec(theirs.color));
    if (value < of(low) - theirs.tolerance || value > of(high) + theirs.tolerance) return false;
  }
  return true;
}

/// What is seen within `edge` pixels of the pixel's centre.
std::vector<Fragment> around(const Reference& reference, PixelPlace place, double edge) {
  return reference.probe.around(place.x + 0.5, place.y + 0.5, edge);
}

bool at_triangle_edge(const Fragment& here, const std::vector<Fragment>& moved) {
  return std::ranges::any_of(moved, [&](const Fragment& f) { return f.triangle != here.triangle; });
}

/// The fragment behind the surface that the pixel's centre sees.
Fragment behind_sample(const Reference& reference, PixelPlace place) {
  const double depth = reference.fragments.at(place.x, place.y).depth;
  constexpr double kSameSurface = 1e-6;  // float32 depths of two triangles that meet at an edge
  return reference.probe.at(place.x + 0.5, place.y + 0.5, depth * (1 + kSameSurface));
}

bool has_16_bits(const Texture& texture) {
  const auto* image = std::get_if<TextureImage>(&texture);
  const auto is_multiple = [](float v) {
    const double steps = 65535 * double(v);
    return std::abs(steps - std::round(steps)) < 0.01;  // float32
  };
  return !image || std::ranges::all_of(image->pixels, [&](const Rgb& c) {
    return is_multiple(c.r) && is_multiple(c.g) && is_multiple(c.b);
  });
}

}  // namespace

Grid<char> silhouettes(const Scene& scene, const Grid<Fragment>& fragments) {
  const double pixel_width =
      Projection(scene.view.camera, fragments.width, fragments.height).pixel_width();
  Grid<char> result(fragments.width, fragments.height);
  oneapi::tbb::parallel_for(0, fragments.height, [&](int y) {
    for (int x = 0; x < fragments.width; ++x) {
      const bool at_edge =
          fragments.at(x, y).covered() && at_silhouette(scene, fragments, pixel_width, x, y);
      result.at(x, y) = at_edge ? 1 : 0;
    }
  });
  return result;
}

bool faces_away(const Scene& scene, const Fragment& fragment) {
  return dot(fragment.normal, scene.view.camera.position - fragment.position) < 0;
}

double channel_error(const Vec3d& ours, const Rgb& theirs, bool limited) {
  const auto error = [limited](double mine, double yours) {
    return limited ? std::abs(std::clamp(mine, 0.0, 1.0) - std::clamp(yours, 0.0, 1.0))
                   : std::abs(mine - yours);
  };
  return std::max({error(ours.x, theirs.r), error(ours.y, theirs.g), error(ours.z, theirs.b)});
}

Reference::Reference(const Scene& s, const Grid<Fragment>& f)
    : scene(s),
      fragments(f),
      silhouettes(lumaknot::validate::silhouettes(s, f)),
      silhouette_length(std::ranges::count(silhouettes.pixels, char{1})),
      texture_has_16_bits(has_16_bits(s.texture)),
      probe(s.mesh, s.view.camera, f.width, f.height) {}

Explainer::Explainer(const Reference& reference, const Shot& shot)
    : reference_(reference),
      gated_shot_(gated(shot)),
      free_(reference.scene, shot),
      gated_(reference.scene, gated_shot_) {}

Vec3d Explainer::drawn_with(Habits habits, Fragment fragment) const {
  if (habits.turns && faces_away(reference_.scene, fragment)) fragment.normal = -fragment.normal;
  return (habits.gates ? gated_ : free_).color(fragment);
}

bool Explainer::lies_among(const std::vector<Fragment>& fragments, const TheirPixel& theirs) const {
  return std::ranges::any_of(kAllHabits, [&](Habits habits) {
    std::vector<Vec3d> colors;
    for (const Fragment& f : fragments) {
      if (f.covered()) colors.push_back(drawn_with(habits, f));
    }
    return !colors.empty() && validate::lies_among(colors, theirs);
  });
}

bool Explainer::at_texel_edge(const Fragment& fragment, const TheirPixel& theirs) const {
  const auto* texture = std::get_if<TextureImage>(&reference_.scene.texture);
  if (!texture) return false;
  constexpr double kTexels = 0.01;
  std::vector<Fragment> moved(5, fragment);
  for (std::size_t i = 0; i < 4; ++i) {
    moved[i].uv.u += (i % 2 ? kTexels : -kTexels) / texture->width;
    moved[i].uv.v += (i / 2 ? kTexels : -kTexels) / texture->height;
  }
  return lies_among(moved, theirs);
}

PixelClass Explainer::explain(const TheirPixel& theirs) const {
  const Fragment& fragment = reference_.fragments.at(theirs.place.x, theirs.place.y);
  const auto agrees_with = [&](Habits habits) {
    return agrees(drawn_with(habits, fragment), theirs);
  };
  if (agrees_with({.gates = true})) return PixelClass::kGatedHighlight;
  if (agrees_with({.turns = true}) || agrees_with({.turns = true, .gates = true})) {
    return PixelClass::kTurnedNormal;
  }
  if (at_texel_edge(fragment, theirs)) return PixelClass::kTexelEdge;
  std::vector<Fragment> moved = around(reference_, theirs.place, theirs.edge);
  const bool crosses = at_triangle_edge(fragment, moved);
  moved.push_back(fragment);
  if (lies_among(moved, theirs)) return PixelClass::kSilhouette;
  const bool slips = crosses && lies_among({behind_sample(reference_, theirs.place)}, theirs);
  return slips ? PixelClass::kSlippedRay : PixelClass::kUnexplained;
}

bool explains_coverage(const Reference& reference, PixelPlace place, double edge) {
  const Fragment& here = reference.fragments.at(place.x, place.y);
  const std::vector<Fragment> moved = around(reference, place, edge);
  const bool differs =
      std::ranges::any_of(moved, [&](const Fragment& f) { return f.covered() != here.covered(); });
  return differs || (here.covered() && at_triangle_edge(here, moved) &&
                     !behind_sample(reference, place).covered());
}

}  // namespace lumaknot::validate
