#include "study/error_budget.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "render/fast_renderer.h"
#include "render/shading.h"
#include "render/texture.h"
#include "render/truth.h"
#include "scene/error.h"
#include "study/knot_samples.h"

namespace lumaknot {
namespace {

Material in_exact_space(Material material) {
  if (is_linear(material.space)) material.form = Form::kCollapsed;
  return material;
}

/// The scene's formula with other numbers for one pixel, in double.
class Painter {
 public:
  Painter(const Scene& scene, const Material& material)
      : texture_(scene.texture), shot_{"final", Stage::kFinal, material}, shading_(scene, shot_) {}
  Painter(const Painter&) = delete;

  Vec3d texture(const Fragment& seen) const { return texture_color(texture_, seen.uv); }
  Vec3d color(const Fragment& seen) const { return shading_.color(seen); }
  Vec3d color(const Fragment& seen, const Vec3d& texture) const {
    return shading_.color(seen, texture);
  }

 private:
  const Texture& texture_;
  Shot shot_;
  Shading shading_;
};

Fragment with_normal(Fragment seen, const Vec3d& normal) {
  seen.normal = normal;
  return seen;
}

/// The method's picture in double, and the same with one stage exact.
struct Pictures {
  ErrorMap method, tessellation, normal, unit, space, filter, sampling, centre;

  Pictures(int width, int height)
      : method(width, height),
        tessellation(width, height),
        normal(width, height),
        unit(width, height),
        space(width, height),
        filter(width, height),
        sampling(width, height),
        centre(width, height) {}
};

class Swaps {
 public:
  Swaps(const Scene& scene, const KnotSpec& knot, int samples)
      : scene_(scene),
        samples_(samples),
        grid_(knot, scene.mesh),
        as_is_(scene, scene.view.material),
        unit_(scene, with_unit(scene.view.material)),
        exact_space_(scene, in_exact_space(scene.view.material)),
        exact_(scene, in_exact_space(with_unit(scene.view.material))),
        exact_seen_(exact_fragments(scene, knot)),
        mesh_seen_(visible_fragments(scene)) {}

  Pictures draw(const Progress& progress) const {
    const ImageSpec& image = scene_.view.image;
    Pictures pictures(image.width, image.height);
    const int n = samples_;
    const Rasterizer rasterizer(scene_.mesh, scene_.view.camera, image.width * n, image.height * n,
                                n);
    std::mutex reporting;
    int finished = 0;
    oneapi::tbb::parallel_for(0, image.height, [&](int y) {
      const Grid<Fragment> band = rasterizer.band(y);
      for (int x = 0; x < image.width; ++x) {
        swap_at_centre(x, y, pictures);
        swap_means(x, y, band, pictures);
      }
      if (!progress) return;
      const std::lock_guard lock(reporting);
      progress(double(++finished) / image.height);
    });
    return pictures;
  }

 private:
  static Material with_unit(Material material) {
    material.normal = NormalUse::kUnit;
    return material;
  }

  void swap_at_centre(int x, int y, Pictures& pictures) const {
    const Fragment& seen = mesh_seen_.at(x, y);
    const ExactFragment& exact = exact_seen_.at(x, y);
    pictures.method.at(x, y) = as_is_.color(seen);
    pictures.unit.at(x, y) = unit_.color(seen);
    pictures.space.at(x, y) = exact_space_.color(seen);
    pictures.tessellation.at(x, y) = as_is_.color(grid_.of_tube(exact).seen);
    pictures.centre.at(x, y) = exact_.color(exact.fragment);
    if (!seen.covered()) return;
    // Its direction alone: the length is a stage of its own.
    const Vec3d normal = grid_.exact_normal(grid_.of_mesh(seen)) * length(seen.normal);
    pictures.normal.at(x, y) = as_is_.color(with_normal(seen, normal));
  }

  /// Whether two fragments lie near each other on one sheet of the surface.
  bool same_sheet(const Fragment& a, const Fragment& b) const {
    return dot(a.normal, b.normal) > 0.5 && std::abs(a.depth - b.depth) < 0.05 * a.depth &&
           length(a.position - b.position) < 0.05 * a.depth;
  }

  /// The texture's mean over the centre's sheet, light at the centre; and the light's and the
  /// coverage's mean, the texture as the centre has it on its sheet.
  void swap_means(int x, int y, const Grid<Fragment>& band, Pictures& pictures) const {
    const int n = samples_;
    const Fragment& centre = mesh_seen_.at(x, y);
    const Vec3d texture = centre.covered() ? as_is_.texture(centre) : Vec3d{};
    Vec3d texture_sum, color_sum;
    int on_sheet = 0;
    for (int s = 0; s < n * n; ++s) {
      const Fragment& sample = band.at(x * n + s % n, s / n);
      if (!sample.covered()) continue;
      const Vec3d own = as_is_.texture(sample);
      const bool on = centre.covered() && same_sheet(centre, sample);
      if (on) texture_sum = texture_sum + own, ++on_sheet;
      color_sum = color_sum + as_is_.color(sample, on ? texture : own);
    }
    const Vec3d mean = on_sheet ? texture_sum / double(on_sheet) : texture;
    pictures.filter.at(x, y) = as_is_.color(centre, mean);
    pictures.sampling.at(x, y) = color_sum / (double(n) * n);
  }

  const Scene& scene_;
  int samples_;
  KnotGrid grid_;
  Painter as_is_, unit_, exact_space_, exact_;
  Grid<ExactFragment> exact_seen_;
  Grid<Fragment> mesh_seen_;
};

ErrorMap colors_of(const Image& image) {
  ErrorMap map(image.width, image.height);
  std::ranges::transform(image.pixels, map.pixels.begin(),
                         [](const RgbaPixel& p) { return to_vec(p.color); });
  return map;
}

ErrorMap colors_of(const Grid<Rgba8>& image) {
  ErrorMap map(image.width, image.height);
  std::ranges::transform(image.pixels, map.pixels.begin(), [](const Rgba8& p) {
    return Vec3d{p.r / 255.0, p.g / 255.0, p.b / 255.0};
  });
  return map;
}

ErrorMap limited(ErrorMap map) {
  for (Vec3d& color : map.pixels) color = saturate(color);
  return map;
}

ErrorMap minus(ErrorMap a, const ErrorMap& b) {
  for (std::size_t i = 0; i < a.pixels.size(); ++i) a.pixels[i] = a.pixels[i] - b.pixels[i];
  return a;
}

/// The pixels that count, and root mean squares over them.
class Covered {
 public:
  Covered(const Image& drawn, const Image& truth) {
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
      if (drawn.pixels[i].coverage > 0 || truth.pixels[i].coverage > 0) pixels_.push_back(i);
    }
  }

  long long count() const { return static_cast<long long>(pixels_.size()); }

  BudgetPart part(std::string name, std::string exact, ErrorMap map) const {
    BudgetPart result{std::move(name), std::move(exact), 0, 0, std::move(map)};
    for (const std::size_t i : pixels_) {
      for (const double channel : components(result.map.pixels[i])) {
        result.rmse += channel * channel;
        result.max = std::max(result.max, std::abs(channel));
      }
    }
    result.rmse = std::sqrt(result.rmse / (3.0 * double(pixels_.size())));
    return result;
  }

 private:
  std::vector<std::size_t> pixels_;
};

void check(const Scene& scene) {
  if (scene.view.image.samples != 1) {
    throw Error("image.samples must be 1 for a budget: it is of one sample a pixel; leave it out");
  }
  if (scene.view.material.rate == Rate::kVertex) {
    throw Error(
        "material.rate must be \"pixel\" for a budget: light a vertex has no stage in it; leave it "
        "out");
  }
}

/// The fast renderer's picture, in float and in bytes.
struct FastPictures {
  Image floats;
  Grid<Rgba8> bytes;
};

FastPictures draw_fast(const Scene& scene) {
  FastPictures drawn;
  FastRenderer renderer(scene, {});
  renderer.draw(drawn.floats);
  renderer.draw(drawn.bytes);
  return drawn;
}

double root_mean_square(const Grid<float>& values, long long count) {
  double sum = 0;
  for (const float value : values.pixels) sum += double(value) * value;
  return std::sqrt(sum / double(count));
}

/// `whole` minus each of `maps`.
ErrorMap remainder_of(ErrorMap whole, const std::vector<BudgetPart>& parts) {
  for (const BudgetPart& part : parts) whole = minus(std::move(whole), part.map);
  return whole;
}

}  // namespace

ErrorBudget error_budget(const Scene& scene, const KnotSpec& knot, const BudgetOptions& options,
                         const Progress& progress) {
  check(scene);
  const auto share = [&](double from, double to) -> Progress {
    if (!progress) return {};
    return [&progress, from, to](double done) { progress(from + (to - from) * done); };
  };
  Scene exact{{}, scene.texture, scene.view};
  exact.view.material = in_exact_space(scene.view.material);
  const Truth truth =
      draw_truth(exact, knot, {TruthSampling::kArea, options.tolerance}, share(0, 0.7));
  const Pictures swapped = Swaps(scene, knot, options.samples).draw(share(0.7, 1));
  const FastPictures fast = draw_fast(scene);
  const ErrorMap floats = colors_of(fast.floats), bytes = colors_of(fast.bytes);
  const Covered covered(fast.floats, truth.image);
  if (covered.count() == 0) throw Error("no pixel shows the knot; move the camera");

  const ErrorMap& method = swapped.method;
  ErrorBudget budget;
  budget.pixels = covered.count();
  const auto add = [&](const char* name, const char* form, ErrorMap map) {
    budget.parts.push_back(covered.part(name, form, std::move(map)));
  };
  add("tessellation", "the exact tube", minus(method, swapped.tessellation));
  add("normal interpolation", "the tube's normal", minus(method, swapped.normal));
  add("unnormalised normal", "a unit normal", minus(method, swapped.unit));
  add("colour space", "T + (Y_F - Y_T)", minus(method, swapped.space));
  const ErrorMap geometry = minus(method, swapped.centre);
  budget.centre = covered.part("", "", geometry).rmse;
  budget.centre_left = covered.part("", "", remainder_of(geometry, budget.parts)).rmse;
  add("texture filter", "the texture's mean over the pixel", minus(method, swapped.filter));
  add("sampling", "coverage's and light's mean over the pixel", minus(method, swapped.sampling));
  add("shading arithmetic", "double", minus(floats, method));
  add("clamp", "colours beyond [0, 1]", minus(limited(floats), floats));
  add("quantisation", "no steps of 1/255", minus(bytes, limited(floats)));
  budget.whole = covered.part("whole", "the truth", minus(bytes, colors_of(truth.image)));
  budget.left = covered.part("left over", "stages that act on each other",
                             remainder_of(budget.whole.map, budget.parts));
  budget.truth_error = root_mean_square(truth.error, budget.pixels);
  return budget;
}

}  // namespace lumaknot
