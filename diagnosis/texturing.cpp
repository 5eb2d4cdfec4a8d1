#include "diagnosis/texturing.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/colors.h"
#include "render/projection.h"
#include "render/texture.h"

namespace lumaknot::diagnosis {
namespace {

/// The weights of the triangle's corners where the ray meets its plane.
std::array<double, 3> weights_at(const std::array<Vec3d, 3>& corners, const Vec3d& ray) {
  const std::array<double, 3> volumes{dot(ray, cross(corners[1], corners[2])),
                                      dot(ray, cross(corners[2], corners[0])),
                                      dot(ray, cross(corners[0], corners[1]))};
  const double sum = volumes[0] + volumes[1] + volumes[2];
  return {volumes[0] / sum, volumes[1] / sum, volumes[2] / sum};
}

}  // namespace

Texturing::Texturing(const Setup& setup) : setup_(setup) {
  const auto* image = std::get_if<TextureImage>(setup.texture.get());
  if (!image) return;
  const TextureUse& use = setup.texturing;
  const bool changes = use.gamma != 1 || use.curve != Curve::kNone || use.saturation != 1 ||
                       use.channels != TextureUse{}.channels;
  changes_texels_ = changes && !use.after_filtering;
  width_ = image->width;
  height_ = image->height;
  if (setup.texturing.sampling != Sampling::kMipmapped) return;
  TextureImage level = *image;
  while (level.width > 1 || level.height > 1) {
    level = halved(level);
    levels_.emplace_back(level);
  }
}

Vec2d Texturing::coordinates(const Vec2d& uv) const {
  const TextureUse& use = setup_.texturing;
  const double u = use.swapped ? uv.v : uv.u, v = use.swapped ? uv.u : uv.v;
  Vec2d result{use.u_scale * u + use.u_offset, use.v_scale * v + use.v_offset};
  if (width_ > 0) {
    result.u += use.texel_shift / width_;
    result.v += use.texel_shift / height_;
  }
  if (use.wrapping == Wrapping::kClamp && width_ > 0) {
    result.u = std::clamp(result.u, 0.5 / width_, 1 - 0.5 / width_);
    result.v = std::clamp(result.v, 0.5 / height_, 1 - 0.5 / height_);
  }
  return result;
}

Vec3d Texturing::color(const Fragment& fragment) const {
  const Vec3d color = read(coordinates(fragment.uv), fragment);
  return setup_.texturing.after_filtering ? changed(color) : color;
}

Vec3d Texturing::changed(const Vec3d& color) const {
  const TextureUse& use = setup_.texturing;
  return saturated(curved(use.curve, powered(permuted(use.channels, color), use.gamma)),
                   use.saturation);
}

Vec3d Texturing::bilinear_at(const Texture& texture, const Vec2d& uv) const {
  if (!changes_texels_) return texture_color(texture, uv);
  return bilinear(std::get<TextureImage>(texture), uv,
                  [this](const Vec3d& texel) { return changed(texel); });
}

Vec3d Texturing::read(const Vec2d& uv, const Fragment& fragment) const {
  if (!levels_.empty()) return mipmapped(uv, fragment);
  if (setup_.texturing.sampling != Sampling::kNearest || width_ == 0) {
    return bilinear_at(*setup_.texture, uv);
  }
  const Vec2d centre{(std::floor(uv.u * width_) + 0.5) / width_,
                     (std::floor(uv.v * height_) + 0.5) / height_};
  return bilinear_at(*setup_.texture, centre);
}

Vec3d Texturing::mipmapped(const Vec2d& uv, const Fragment& fragment) const {
  const double level =
      std::clamp(std::log2(std::max(footprint(fragment), 1e-9)), 0.0, double(levels_.size()));
  const auto at = [&](std::size_t i) {
    return bilinear_at(i == 0 ? *setup_.texture : levels_[i - 1], uv);
  };
  const auto lower = std::min(std::size_t(level), levels_.size() - 1);
  const Vec3d fine = at(lower), coarse = at(lower + 1);
  return fine + (coarse - fine) * (level - double(lower));
}

double Texturing::footprint(const Fragment& fragment) const {
  const TriangleMesh& mesh = *setup_.mesh;
  const Projection projection(setup_.view.camera, setup_.view.image.width,
                              setup_.view.image.height);
  const Triangle& t = mesh.triangles[std::size_t(fragment.triangle)];
  const std::array<Vec3d, 3> corners{projection.to_view(mesh.positions[t[0]]),
                                     projection.to_view(mesh.positions[t[1]]),
                                     projection.to_view(mesh.positions[t[2]])};
  const Vec3d here = projection.to_image(projection.to_view(fragment.position));
  const auto uv_at = [&](double x, double y) {
    const std::array<double, 3> weights = weights_at(corners, projection.ray(x, y));
    Vec2d uv;
    for (std::size_t i = 0; i < 3; ++i) {
      uv.u += mesh.uvs[t[i]].u * weights[i];
      uv.v += mesh.uvs[t[i]].v * weights[i];
    }
    return uv;
  };
  constexpr double kStep = 1e-3;  // pixels: a derivative
  const TextureUse& use = setup_.texturing;
  const auto texels = [&](const Vec2d& a, const Vec2d& b) {
    return std::hypot(use.u_scale * (a.u - b.u) * width_, use.v_scale * (a.v - b.v) * height_) /
           kStep;
  };
  const Vec2d uv = uv_at(here.x, here.y);
  return std::max(texels(uv_at(here.x + kStep, here.y), uv),
                  texels(uv_at(here.x, here.y + kStep), uv));
}

}  // namespace lumaknot::diagnosis
