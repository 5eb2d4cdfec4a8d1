#include "validate/compare/sensitivity.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/texture.h"
#include "shaders/formulas/lighting.h"
#include "shaders/graph/uncertain.h"

namespace lumaknot::validate {
namespace {

// The deviation of a rounding of float32 relative to the value: half a unit / sqrt(3).
constexpr double kRounding = 0x1p-24 * 0.57735026918962576;
constexpr double kSigmas = 4;              // one pixel in 16,000 exceeds so many
constexpr double kStepPixels = 1.0 / 512;  // finite differences in the image
constexpr double kStepTexels = 1.0 / 64;   // and in the texture

double largest(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Computes the sensitivities of one shot's pixels.
class Prober {
 public:
  Prober(const Reference& reference, const Shot& shot)
      : reference_(reference),
        scene_(reference.scene),
        shot_(shot),
        shading_(reference.scene, shot),
        lighting_(lighting_of<Uncertain>(reference.scene.view, shot.material)) {}

  Sensitivity of(const Fragment& fragment, PixelPlace place) const {
    Sensitivity result;
    result.sample_scale = float(sample_scale(fragment, place));
    if (!fragment.covered()) return result;
    move_sample(fragment, place, result);
    round(fragment, result);
    return result;
  }

 private:
  /// The point of the fragment's triangle seen from another sample, its weights limited to the
  /// triangle.
  Fragment moved(const Fragment& fragment, const Edges& edges, double x, double y) const {
    const Rasterizer& rasterizer = reference_.probe.rasterizer();
    const Vec3d ray = rasterizer.projection().ray(x, y);
    std::array<double, 3> weights{};
    for (std::size_t i = 0; i < 3; ++i) weights[i] = std::max(0.0, dot(edges.planes[i], ray));
    if (edges.swapped) std::swap(weights[1], weights[2]);
    const double sum = weights[0] + weights[1] + weights[2];
    if (!(sum > 0)) return fragment;
    for (double& weight : weights) weight /= sum;
    return rasterizer.fragment(std::uint32_t(fragment.triangle), fragment.depth, weights);
  }

  void move_sample(const Fragment& fragment, PixelPlace place, Sensitivity& result) const {
    const Edges edges = reference_.probe.rasterizer().edges(std::uint32_t(fragment.triangle));
    const Vec3d here = shading_.color(fragment);
    const auto color = [&](double dx, double dy) {
      return shading_.color(moved(fragment, edges, place.x + 0.5 + dx, place.y + 0.5 + dy));
    };
    const Vec3d left = color(-kStepPixels, 0), right = color(kStepPixels, 0);
    const Vec3d up = color(0, -kStepPixels), down = color(0, kStepPixels);
    const Vec3d along_x = (right - left) / (2 * kStepPixels);
    const Vec3d along_y = (down - up) / (2 * kStepPixels);
    double most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double c = components(here)[i];
      const double step_x =
          std::max(std::abs(components(left)[i] - c), std::abs(components(right)[i] - c));
      const double step_y =
          std::max(std::abs(components(up)[i] - c), std::abs(components(down)[i] - c));
      result.step = std::max(result.step, float((step_x + step_y) / kStepPixels));
      const double slope = std::abs(components(along_x)[i]) + std::abs(components(along_y)[i]);
      if (slope <= most) continue;
      most = slope;
      result.channel = std::uint8_t(i);
      result.slope_x = float(components(along_x)[i]);
      result.slope_y = float(components(along_y)[i]);
    }
    result.size = float(largest(here));
  }

  /// In pixels: the distance from the image's corner, and that from the world's origin as seen at
  /// the surface's depth.
  double sample_scale(const Fragment& fragment, PixelPlace place) const {
    const double focal = 1 / reference_.probe.rasterizer().projection().pixel_width();
    const Camera& camera = scene_.view.camera;
    const double depth =
        fragment.covered() ? fragment.depth : length(camera.target - camera.position);
    const double reach = std::max(length(fragment.position), length(camera.position));
    return focal * std::max(1.0, reach / depth) + std::max(place.x, place.y);
  }

  /// The texture as the form of the material has it, each component with the deviation that a
  /// rounding of the texture coordinates gives it.
  Vec<Uncertain> texture_at(const Fragment& fragment, double& filter) const {
    const Vec3d here = texture_value(texture_color(scene_.texture, fragment.uv), shot_.material);
    Vec<Uncertain> value = constant_vec<Uncertain>(here);
    const auto* image = std::get_if<TextureImage>(&scene_.texture);
    if (!image) return value;
    Vec2d scale;
    for (const std::uint32_t v : scene_.mesh.triangles[std::size_t(fragment.triangle)]) {
      scale.u = std::max(scale.u, std::abs(scene_.mesh.uvs[v].u));
      scale.v = std::max(scale.v, std::abs(scene_.mesh.uvs[v].v));
    }
    const auto at = [&](double du, double dv) {
      const Vec2d uv{fragment.uv.u + du / image->width, fragment.uv.v + dv / image->height};
      return texture_value(texture_color(scene_.texture, uv), shot_.material) - here;
    };
    const std::array<Vec3d, 4> steps{at(-kStepTexels, 0), at(kStepTexels, 0), at(0, -kStepTexels),
                                     at(0, kStepTexels)};
    const auto larger = [](const Vec3d& a, const Vec3d& b) {
      return (largest(a) > largest(b) ? a : -b) / kStepTexels;
    };
    const Vec3d along_u = larger(steps[1], steps[0]), along_v = larger(steps[3], steps[2]);
    filter = largest(along_u) + largest(along_v);
    Uncertain* parts[] = {&value.x, &value.y, &value.z};
    for (std::size_t i = 0; i < 3; ++i) {
      parts[i]->slope = {components(along_u)[i] * scale.u * image->width * kRounding,
                         components(along_v)[i] * scale.v * image->height * kRounding};
      // Files hold 16 bits.
      if (!reference_.texture_has_16_bits) {
        (*parts[i])[ErrorSource::kTexel] = Uncertain::squared(kStep16) / 12;
      }
    }
    return value;
  }

  /// A vector of which each component errs by a rounding of `scale`.
  static Vec<Uncertain> rounded(const Vec3d& v, ErrorSource source, double scale) {
    const auto one = [&](double x) {
      Uncertain result;
      result.value = x;
      result[source] = Uncertain::squared(scale * kRounding);
      return result;
    };
    return {one(v.x), one(v.y), one(v.z)};
  }

  Terms<Uncertain> terms_at(const Vec3d& position, const Vec3d& normal) const {
    const SurfacePoint<Uncertain> point{
        rounded(position, ErrorSource::kPosition, largest(position)),
        rounded(normal, ErrorSource::kNormal, largest(normal))};
    return surface_terms(point, lighting_.eye_position, lighting_.lights, lighting_.parameters,
                         shot_.material);
  }

  Terms<Uncertain> terms_of(const Fragment& fragment) const {
    if (shot_.material.rate != ShadingFrequency::kVertex) {
      return terms_at(fragment.position, fragment.normal);
    }
    Terms<Uncertain> sum;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = scene_.mesh.triangles[std::size_t(fragment.triangle)][i];
      const Terms<Uncertain> corner = terms_at(scene_.mesh.positions[v], scene_.mesh.normals[v]);
      sum.diffuse = sum.diffuse + corner.diffuse * Uncertain(fragment.weights[i]);
      sum.specular = sum.specular + corner.specular * Uncertain(fragment.weights[i]);
    }
    return sum;
  }

  void round(const Fragment& fragment, Sensitivity& result) const {
    const bool textured = shot_.stage == Stage::kTexture || shot_.stage == Stage::kFinal;
    double filter = 0;
    const Vec<Uncertain> texture =
        textured ? texture_at(fragment, filter) : constant_vec<Uncertain>({});
    const Terms<Uncertain> terms =
        shot_.stage == Stage::kTexture ? Terms<Uncertain>{} : terms_of(fragment);
    const Vec<Uncertain> color = stage_color(texture, terms, lighting_, shot_);
    const auto deviation = [&](ErrorSource source) {
      const auto of = [&](const Uncertain& c) { return c.variance[std::size_t(source)]; };
      return float(std::sqrt(std::max({of(color.x), of(color.y), of(color.z)})));
    };
    // The colour itself is rounded too, though it may be a constant.
    result.formula = std::hypot(deviation(ErrorSource::kFormula), float(kRounding) * result.size);
    result.power = deviation(ErrorSource::kPower);
    result.position = deviation(ErrorSource::kPosition);
    result.normal = deviation(ErrorSource::kNormal);
    const auto along = [](const Uncertain& c) { return std::hypot(c.slope[0], c.slope[1]); };
    result.texture = float(std::max({along(color.x), along(color.y), along(color.z)}));
    result.texel = deviation(ErrorSource::kTexel);
    result.filter = float(filter);
  }

  const Reference& reference_;
  const Scene& scene_;
  const Shot& shot_;
  Shading shading_;
  Lighting<Uncertain> lighting_;
};

}  // namespace

double LimitParts::sum() const {
  const auto part = [&](LimitPart p) { return of[std::size_t(p)]; };
  double squares = 0;
  for (const LimitPart p : {LimitPart::kSample, LimitPart::kPosition, LimitPart::kNormal,
                            LimitPart::kTexture, LimitPart::kTexel, LimitPart::kFormula}) {
    squares += part(p) * part(p);
  }
  return part(LimitPart::kSnapped) + part(LimitPart::kFilter) + part(LimitPart::kOutput) +
         std::sqrt(squares);
}

Grid<Sensitivity> sensitivities(const Reference& reference, const Shot& shot) {
  const Grid<Fragment>& fragments = reference.fragments;
  Grid<Sensitivity> result(fragments.width, fragments.height);
  const Prober prober(reference, shot);
  oneapi::tbb::parallel_for(0, fragments.height, [&](int y) {
    for (int x = 0; x < fragments.width; ++x) {
      result.at(x, y) = prober.of(fragments.at(x, y), {x, y});
    }
  });
  return result;
}

Sensitivity sensitivity_of(const Reference& reference, const Shot& shot, const Fragment& fragment,
                           PixelPlace place) {
  return Prober(reference, shot).of(fragment, place);
}

LimitParts limit_of(const Sensitivity& pixel, const Promise& promise, double output_steps) {
  LimitParts result;
  const auto set = [&](LimitPart part, double value) { result.of[std::size_t(part)] = value; };
  const double half_cell = promise.snaps_shade ? std::exp2(-promise.grid_bits - 1) : 0;
  set(LimitPart::kSnapped, half_cell * pixel.step);
  set(LimitPart::kSample, sample_error(pixel, promise) * pixel.step);
  set(LimitPart::kPosition, kSigmas * promise.position_roundings * pixel.position);
  set(LimitPart::kNormal, kSigmas * promise.normal_roundings * pixel.normal);
  set(LimitPart::kTexture, kSigmas * promise.uv_roundings * pixel.texture);
  set(LimitPart::kTexel, kSigmas * promise.texture_step / kStep16 * pixel.texel);
  set(LimitPart::kFilter, promise.texel_weight * pixel.filter);
  set(LimitPart::kFormula, std::hypot(kSigmas * promise.formula_roundings * pixel.formula,
                                      promise.power_error / kPowerUnit * pixel.power));
  constexpr double kNegligible = 1e-9;  // no image file has steps so fine
  set(LimitPart::kOutput,
      output_steps * (promise.output_step + promise.output_relative * pixel.size) / 2 +
          kNegligible);
  return result;
}

double sample_error(const Sensitivity& pixel, const Promise& promise) {
  return kSigmas * promise.sample_roundings * kRounding * pixel.sample_scale;
}

double edge_distance(const Sensitivity& pixel, const Promise& promise) {
  const double cell = promise.grid_bits > 0 ? std::exp2(-promise.grid_bits) : 0;
  return cell + sample_error(pixel, promise);
}

}  // namespace lumaknot::validate
