#include "validate/explain.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "render/projection.h"

namespace lumaknot {
namespace {

Vec3d triangle_normal(const TriangleMesh& mesh, const Fragment& fragment) {
  const Triangle& t = mesh.triangles[std::size_t(fragment.triangle)];
  const Vec3d normal = cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                             mesh.positions[t[2]] - mesh.positions[t[0]]);
  const double size = length(normal);
  return size > 0 ? normal / size : normal;
}

bool one_sheet(const TriangleMesh& mesh, const Fragment& a, const Fragment& b, double tolerance) {
  const Vec3d apart = b.position - a.position;
  return std::abs(dot(triangle_normal(mesh, a), apart)) <= tolerance ||
         std::abs(dot(triangle_normal(mesh, b), apart)) <= tolerance;
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

Shot without_highlight(Shot shot) {
  shot.material.specular = 0;
  return shot;
}

/// Our colour where highlights are gated: none where the light is behind the surface.
Vec3d gated(const Scene& scene, const Shot& shot, const Fragment& fragment) {
  if (shot.stage == Stage::kSpecular) return {};
  return shade(scene, without_highlight(shot), fragment);
}

bool texel_edge(const Scene& scene, const Shot& shot, const Fragment& fragment, const Rgb& theirs,
                double tolerance) {
  const auto* texture = std::get_if<TextureImage>(&scene.texture);
  if (!texture) return false;
  constexpr double kTexels = 0.01;
  Vec3d low = shade(scene, shot, fragment), high = low;
  for (const auto& [du, dv] : {Vec2d{1, 1}, Vec2d{1, -1}, Vec2d{-1, 1}, Vec2d{-1, -1}}) {
    Fragment moved = fragment;
    moved.uv.u += du * kTexels / texture->width;
    moved.uv.v += dv * kTexels / texture->height;
    const Vec3d c = shade(scene, shot, moved);
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
  }
  const auto within = [&](double lowest, double highest, double value) {
    return value >= lowest - tolerance && value <= highest + tolerance;
  };
  return within(low.x, high.x, theirs.r) && within(low.y, high.y, theirs.g) &&
         within(low.z, high.z, theirs.b);
}

}  // namespace

Grid<char> silhouettes(const Scene& scene, const Grid<Fragment>& fragments) {
  const double pixel_width =
      Projection(scene.view.camera, fragments.width, fragments.height).pixel_width();
  Grid<char> result(fragments.width, fragments.height);
  oneapi::tbb::parallel_for(0, fragments.height, [&](int y) {
    for (int x = 0; x < fragments.width; ++x) {
      result.at(x, y) =
          fragments.at(x, y).covered() && at_silhouette(scene, fragments, pixel_width, x, y);
    }
  });
  return result;
}

double channel_error(const Vec3d& ours, const Rgb& theirs, bool limited) {
  const auto error = [limited](double mine, double yours) {
    return std::abs((limited ? std::clamp(mine, 0.0, 1.0) : mine) - yours);
  };
  return std::max({error(ours.x, theirs.r), error(ours.y, theirs.g), error(ours.z, theirs.b)});
}

PixelClass explain(const Scene& scene, const Shot& shot, const Fragment& fragment,
                   bool at_silhouette, const Rgb& theirs, double tolerance, bool limited) {
  const auto agrees = [&](const Vec3d& ours) {
    return channel_error(ours, theirs, limited) <= tolerance;
  };
  const bool faces_away = dot(fragment.normal, scene.view.camera.position - fragment.position) < 0;
  Fragment turned = fragment;
  if (faces_away) turned.normal = -turned.normal;
  const bool lit = dot(turned.normal, scene.view.light.position - turned.position) > 0;
  if (faces_away && lit && agrees(shade(scene, shot, turned))) return PixelClass::kTurnedNormal;
  if (!lit && agrees(gated(scene, shot, turned))) {
    return faces_away ? PixelClass::kTurnedNormal : PixelClass::kGatedHighlight;
  }
  if (texel_edge(scene, shot, fragment, theirs, tolerance)) return PixelClass::kTexelEdge;
  return at_silhouette ? PixelClass::kSilhouette : PixelClass::kUnexplained;
}

}  // namespace lumaknot
