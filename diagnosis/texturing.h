/// The surface's own colour, read as a setup says.
#pragma once

#include "diagnosis/setup.h"
#include "render/rasterizer.h"

namespace lumaknot::diagnosis {

/// A texture prepared for many fragments. Keeps the setup by reference.
class Texturing {
 public:
  explicit Texturing(const Setup& setup);

  /// The colour at a fragment, r'g'b'.
  Vec3d color(const Fragment& fragment) const;

 private:
  Vec2d coordinates(const Vec2d& uv) const;
  /// What is done to a colour.
  Vec3d changed(const Vec3d& color) const;
  Vec3d bilinear_at(const Texture& texture, const Vec2d& uv) const;
  Vec3d read(const Vec2d& uv, const Fragment& fragment) const;
  Vec3d mipmapped(const Vec2d& uv, const Fragment& fragment) const;
  /// Texels that the texture coordinates move by from one pixel to the next.
  double footprint(const Fragment& fragment) const;

  const Setup& setup_;
  bool changes_texels_ = false;
  int width_ = 0, height_ = 0;   ///< of an image
  std::vector<Texture> levels_;  ///< below the texture itself; empty unless mipmapped
};

}  // namespace lumaknot::diagnosis
