#include "study/budget/stages.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "render/exact/pixels.h"
#include "render/exact/truth.h"
#include "render/fast/renderer.h"
#include "render/shading.h"
#include "render/texture.h"
#include "study/budget/knot_samples.h"
#include "study/measure/empty_scene.h"
#include "system/error.h"

namespace lumaknot::budget {
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

/// A picture with each stage swapped by itself.
struct Swapped {
  measure::ErrorMap plain, tessellation, normal, unit, space, filter, sampling;

  Swapped(int width, int height)
      : plain(width, height),
        tessellation(width, height),
        normal(width, height),
        unit(width, height),
        space(width, height),
        filter(width, height),
        sampling(width, height) {}
};

/// The method in double with one stage exact, and the truth with one stage of the method's.
struct Pictures {
  Swapped method, truth;
};

/// Whether two fragments are close to each other on one sheet of the surface.
bool same_sheet(const Fragment& a, const Fragment& b) {
  return a.covered() && b.covered() && dot(a.normal, b.normal) > 0.5 &&
         length(a.position - b.position) < 0.05 * a.depth;
}

/// Means over a pixel's samples.
struct PixelMeans {
  Vec3d color;          ///< all of each sample's own
  Vec3d centre_colour;  ///< the centre's texture, on the centre's sheet
  Vec3d texture;        ///< over the centre's sheet
};

PixelMeans means_of(const Painter& painter, const Fragment& centre,
                    const std::vector<Fragment>& samples) {
  PixelMeans means;
  const Vec3d at_centre = centre.covered() ? painter.texture(centre) : Vec3d{};
  int on_sheet = 0;
  for (const Fragment& sample : samples) {
    if (!sample.covered()) continue;
    const Vec3d own = painter.texture(sample), color = painter.color(sample, own);
    const bool on = same_sheet(centre, sample);
    if (on) means.texture = means.texture + own, ++on_sheet;
    means.color = means.color + color;
    means.centre_colour = means.centre_colour + (on ? painter.color(sample, at_centre) : color);
  }
  const double count = double(samples.size());
  return {means.color / count, means.centre_colour / count,
          on_sheet > 0 ? means.texture / double(on_sheet) : at_centre};
}

Vec3d mean_color(const Painter& painter, const std::vector<Fragment>& samples) {
  Vec3d sum;
  for (const Fragment& sample : samples) sum = sum + painter.color(sample);
  return sum / double(samples.size());
}

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
        pixels_(scene, knot),
        mesh_seen_(visible_fragments(scene)) {}

  Pictures draw(const Progress& progress) const {
    const ImageSpec& image = scene_.view.image;
    Pictures pictures{Swapped(image.width, image.height), Swapped(image.width, image.height)};
    const int n = samples_;
    const Rasterizer rasterizer(scene_.mesh, scene_.view.camera, image.width * n, image.height * n,
                                n);
    std::mutex reporting;
    int finished = 0;
    oneapi::tbb::parallel_for(0, image.height, [&](int y) {
      const Grid<Fragment> band = rasterizer.band(y);
      for (int x = 0; x < image.width; ++x) {
        const exact::ExactFragment exact = pixels_.at(x + 0.5, y + 0.5);
        swap_in_method(x, y, exact, mesh_samples(x, band), pictures.method);
        swap_in_truth(x, y, exact.fragment, mesh_samples(x, band), pictures.truth);
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

  std::vector<Fragment> mesh_samples(int x, const Grid<Fragment>& band) const {
    std::vector<Fragment> samples;
    samples.reserve(std::size_t(samples_) * std::size_t(samples_));
    for (int s = 0; s < samples_ * samples_; ++s) {
      samples.push_back(band.at(x * samples_ + s % samples_, s / samples_));
    }
    return samples;
  }

  std::vector<exact::ExactFragment> exact_samples(int x, int y) const {
    std::vector<exact::ExactFragment> samples;
    samples.reserve(std::size_t(samples_) * std::size_t(samples_));
    for (int s = 0; s < samples_ * samples_; ++s) {
      const int column = s % samples_, row = s / samples_;
      samples.push_back(pixels_.at(x + (column + 0.5) / samples_, y + (row + 0.5) / samples_));
    }
    return samples;
  }

  /// The mesh's fragment with the tube's normal.
  Fragment with_exact_normal(const Fragment& seen) const {
    return seen.covered() ? with_normal(seen, grid_.exact_normal(grid_.of_mesh(seen))) : seen;
  }

  void swap_in_method(int x, int y, const exact::ExactFragment& exact,
                      const std::vector<Fragment>& samples, Swapped& method) const {
    const Fragment& seen = mesh_seen_.at(x, y);
    method.plain.at(x, y) = as_is_.color(seen);
    method.tessellation.at(x, y) = as_is_.color(grid_.of_tube(exact).seen);
    method.unit.at(x, y) = unit_.color(seen);
    method.space.at(x, y) = exact_space_.color(seen);
    const PixelMeans means = means_of(as_is_, seen, samples);
    method.filter.at(x, y) = as_is_.color(seen, means.texture);
    method.sampling.at(x, y) = means.centre_colour;
    // Only its direction: the length is a stage of its own.
    const Fragment turned = with_exact_normal(seen);
    method.normal.at(x, y) = as_is_.color(with_normal(turned, turned.normal * length(seen.normal)));
  }

  void swap_in_truth(int x, int y, const Fragment& centre, const std::vector<Fragment>& on_mesh,
                     Swapped& truth) const {
    std::vector<Fragment> samples, interpolated, shortened, meshed;
    for (const exact::ExactFragment& sample : exact_samples(x, y)) {
      const Fragment &seen = sample.fragment, between = grid_.of_tube(sample).seen;
      samples.push_back(seen);
      interpolated.push_back(between);
      shortened.push_back(with_normal(seen, seen.normal * length(between.normal)));
    }
    for (const Fragment& sample : on_mesh) meshed.push_back(with_exact_normal(sample));
    const PixelMeans means = means_of(exact_, centre, samples);
    truth.plain.at(x, y) = means.color;
    truth.tessellation.at(x, y) = mean_color(exact_, meshed);
    truth.normal.at(x, y) = mean_color(exact_, interpolated);
    const bool short_normals = scene_.view.material.normal == NormalUse::kInterpolated;
    truth.unit.at(x, y) = short_normals ? mean_color(exact_space_, shortened) : means.color;
    truth.space.at(x, y) = mean_color(unit_, samples);
    truth.filter.at(x, y) = means.centre_colour;
    truth.sampling.at(x, y) = exact_.color(centre, means.texture);
  }

  const Scene& scene_;
  int samples_;
  KnotGrid grid_;
  Painter as_is_, unit_, exact_space_, exact_;
  exact::ExactPixels pixels_;
  Grid<Fragment> mesh_seen_;
};

/// The pixels that count, and root mean squares over them.
class Covered {
 public:
  Covered(const Image& drawn, const Image& truth) {
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
      if (drawn.pixels[i].coverage > 0 || truth.pixels[i].coverage > 0) pixels_.push_back(i);
    }
  }

  long long count() const { return static_cast<long long>(pixels_.size()); }

  BudgetPart part(std::string name, std::string exact, measure::ErrorMap map) const {
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
    throw Error(
        "image.samples must be 1 for a budget, which has one sample per pixel; leave it out");
  }
  if (scene.view.material.rate == ShadingFrequency::kVertex) {
    throw Error(
        "material.rate must be \"pixel\" for a budget: lighting per vertex has no stage in it; "
        "leave it "
        "out");
  }
}

/// The fast renderer's picture, in float and in bytes.
struct FastPictures {
  Image floats;
  Grid<fast::Rgba8> bytes;
};

FastPictures draw_fast(const Scene& scene) {
  FastPictures drawn;
  fast::Renderer renderer(scene, {});
  renderer.draw(drawn.floats);
  renderer.draw(drawn.bytes);
  return drawn;
}

double root_mean_square(const Grid<float>& values, long long count) {
  double sum = 0;
  for (const float value : values.pixels) sum += double(value) * value;
  return std::sqrt(sum / double(count));
}

/// What a stage changes: the mean of its change in the method and in the truth.
measure::ErrorMap mean_change(const Pictures& p, measure::ErrorMap Swapped::* stage) {
  measure::ErrorMap change = measure::minus(p.method.plain, p.method.*stage);
  const measure::ErrorMap in_truth = measure::minus(p.truth.*stage, p.truth.plain);
  for (std::size_t i = 0; i < change.pixels.size(); ++i) {
    change.pixels[i] = (change.pixels[i] + in_truth.pixels[i]) / 2.0;
  }
  return change;
}

/// `whole` minus the map of each part.
measure::ErrorMap remainder_of(measure::ErrorMap whole, const std::vector<BudgetPart>& parts) {
  for (const BudgetPart& part : parts) whole = measure::minus(std::move(whole), part.map);
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
  const exact::Truth truth = exact::draw_truth(
      exact, knot, {exact::TruthSampling::kArea, options.tolerance}, share(0, 0.5));
  const Pictures swapped = Swaps(scene, knot, options.samples).draw(share(0.5, 1));
  const FastPictures fast = draw_fast(scene);
  const measure::ErrorMap floats = measure::colors_of(fast.floats),
                          bytes = measure::colors_of(fast.bytes);
  const Covered covered(fast.floats, truth.image);
  if (covered.count() == 0) throw Error(measure::kNothingSeen);

  const measure::ErrorMap& method = swapped.method.plain;
  ErrorBudget budget;
  budget.pixels = covered.count();
  const auto add = [&](const char* name, const char* form, measure::ErrorMap map) {
    budget.parts.push_back(covered.part(name, form, std::move(map)));
  };
  const auto add_swapped = [&](const char* name, const char* form,
                               measure::ErrorMap Swapped::* stage) {
    add(name, form, mean_change(swapped, stage));
  };
  add_swapped("tessellation", "the exact tube", &Swapped::tessellation);
  add_swapped("normal interpolation", "the tube's normal", &Swapped::normal);
  add_swapped("unnormalised normal", "a unit normal", &Swapped::unit);
  add_swapped("colour space", "T + (Y_F - Y_T)", &Swapped::space);
  add_swapped("texture filter", "the texture's mean over the pixel", &Swapped::filter);
  add_swapped("sampling", "coverage's and light's mean over the pixel", &Swapped::sampling);
  add("shading arithmetic", "double", measure::minus(floats, method));
  add("clamp", "colours beyond [0, 1]", measure::minus(measure::limited(floats), floats));
  add("quantisation", "no steps of 1/255", measure::minus(bytes, measure::limited(floats)));
  budget.whole =
      covered.part("whole", "the truth", measure::minus(bytes, measure::colors_of(truth.image)));
  budget.left = covered.part("left over", "stages that act on each other",
                             remainder_of(budget.whole.map, budget.parts));
  budget.truth_error = root_mean_square(truth.error, budget.pixels);
  return budget;
}

}  // namespace lumaknot::budget
