#include "study/plan/attribution.h"

#include <algorithm>
#include <cmath>

#include "render/fast/renderer.h"
#include "render/shading.h"
#include "study/budget/knot_samples.h"
#include "study/plan/neighborhood.h"

namespace lumaknot::plan {
namespace {

/// Whether the pixels around (x, y) show one smooth piece of the surface.
bool is_inside(const Grid<SeenPlace>& places, int x, int y) {
  const SeenPlace& own = places.at(x, y);
  if (own.component < 0) return false;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, places.height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, places.width - 1); ++u) {
      if (!on_one_piece(own, places.at(u, v))) return false;
    }
  }
  return true;
}

/// Pixels away from every edge.
std::vector<std::size_t> inside(const Grid<SeenPlace>& places) {
  std::vector<std::size_t> pixels;
  for (int y = 0; y < places.height; ++y) {
    for (int x = 0; x < places.width; ++x) {
      if (is_inside(places, x, y))
        pixels.push_back(std::size_t(y) * std::size_t(places.width) + std::size_t(x));
    }
  }
  return pixels;
}

double largest_difference(const Image& a, const Image& b, std::span<const std::size_t> pixels) {
  double max = 0;
  for (const std::size_t i : pixels) {
    const Vec3d d = saturate(to_vec(a.pixels[i].color)) - saturate(to_vec(b.pixels[i].color));
    max = std::max(max, largest_magnitude(d));
  }
  return max;
}

/// The method with float's part exact.
measure::Method in_double(measure::Method method) {
  method.number = measure::Number::kDouble;
  method.culls = false;
  method.filter = Filter::kBilinear;
  const int root = std::max(1, int(std::lround(std::sqrt(method.samples))));
  method.samples = root * root;
  return method;
}

/// The method's mesh as seen by one sample at each pixel's centre.
class MeshView {
 public:
  MeshView(const measure::Method& method, const KnotSpec& knot, measure::MethodBench& bench)
      : knot_(std::get<KnotSpec>(measure::method_mesh(method, knot))),
        scene_(bench.scene_of(method)),
        seen_(visible(scene_)),
        samples_(seen_.width, seen_.height) {
    const budget::KnotGrid grid(knot_, scene_.mesh);
    std::ranges::transform(seen_.pixels, samples_.pixels.begin(),
                           [&](const Fragment& f) { return grid.of_mesh(f); });
  }

  /// The largest distance of a point from its place, in pixels.
  double place() const {
    const View& view = scene_.view;
    const Projection projection(view.camera, view.image.width, view.image.height);
    const budget::KnotGrid grid(knot_, scene_.mesh);
    const auto on_image = [&](const Vec3d& p) {
      return projection.to_image(projection.to_view(p));
    };
    double max = 0;
    for (const budget::KnotSample& sample : samples_.pixels) {
      if (!sample.seen.covered()) continue;
      const Vec3d d = on_image(sample.seen.position) - on_image(grid.exact_position(sample));
      max = std::max(max, std::hypot(d.x, d.y));
    }
    return max;
  }

  /// The largest change of colour between the method's light and the exact normal's.
  double shading(const measure::Method& method) const {
    const budget::KnotGrid grid(knot_, scene_.mesh);
    const Material& material = scene_.view.material;
    Shot own{"final", Stage::kFinal, measure::true_material(material, material.space)}, exact = own;
    own.material.rate = method.rate;
    const Shading drawn(scene_, own), right(scene_, exact);
    double max = 0;
    for (std::size_t i = 0; i < seen_.pixels.size(); ++i) {
      Fragment fragment = seen_.pixels[i];
      if (!fragment.covered()) continue;
      const Vec3d color = saturate(drawn.color(fragment));
      fragment.normal = grid.exact_normal(samples_.pixels[i]);
      max = std::max(max, largest_magnitude(color - saturate(right.color(fragment))));
    }
    return max;
  }

  std::vector<std::size_t> inside_pixels() const {
    Grid<SeenPlace> places(samples_.width, samples_.height);
    std::ranges::transform(samples_.pixels, places.pixels.begin(), [](const budget::KnotSample& s) {
      return s.seen.covered() ? SeenPlace{s.seen.triangle, s.t, s.theta} : SeenPlace{};
    });
    return inside(places);
  }

 private:
  static Grid<Fragment> visible(Scene scene) {
    scene.view.image.samples = 1;
    return visible_fragments(scene);
  }

  KnotSpec knot_;
  const Scene& scene_;
  Grid<Fragment> seen_;
  Grid<budget::KnotSample> samples_;
};

/// `method` with one part exact.
struct Mended {
  std::string part;
  measure::Method method;
};

std::vector<Mended> mended(const measure::Method& closest, const Candidates& candidates) {
  std::vector<Mended> all;
  const auto add = [&](const char* part, const measure::Method& method) {
    if (!(method == closest)) all.push_back({part, method});
  };
  if (closest.number == measure::Number::kFloat && closest.filter == Filter::kBilinear) {
    add("precision", in_double(closest));
  }
  measure::Method other = closest;
  if (closest.number == measure::Number::kFloat) {
    other.filter = closest.filter == Filter::kBilinear ? Filter::kTrilinear : Filter::kBilinear;
    add("texture filter", other);
  }
  if (closest.samples > 1) {
    other = in_double(closest);
    other.samples = 64;
    add("sampling", other);
  }
  other = closest;
  other.rate = ShadingFrequency::kPixel;
  add("shading", other);
  add("tessellation", measure::with_grid(closest, candidates.ladder.back()));
  return all;
}

Grid<SeenPlace> places_of(const Grid<exact::ExactFragment>& fragments) {
  Grid<SeenPlace> places(fragments.width, fragments.height);
  std::ranges::transform(fragments.pixels, places.pixels.begin(), place_of);
  return places;
}

}  // namespace

std::vector<ErrorPart> error_parts(const measure::Method& method, const KnotSpec& knot,
                                   const Predictor& predictor, measure::MethodBench& bench) {
  const PredictedError predicted = predictor.of(method);
  const MeshView view(method, knot, bench);
  std::vector<ErrorPart> parts{{"place", "pixels", predicted.place, view.place()},
                               {method.rate == ShadingFrequency::kPixel ? "normal between vertices"
                                                                        : "light between vertices",
                                "colour", predicted.shading, view.shading(method)}};
  const std::vector<std::size_t> pixels = view.inside_pixels();
  measure::Method bilinear = method;
  bilinear.filter = Filter::kBilinear;
  const Image drawn = bench.draw(method);
  if (method.samples == 1) {
    const Image plain = bench.draw(bilinear);
    parts.push_back(
        {"texture filter", "colour", predicted.filter, largest_difference(drawn, plain, pixels)});
    parts.push_back({"precision", "colour", predicted.precision,
                     largest_difference(plain, bench.draw(in_double(bilinear)), pixels)});
  } else {
    measure::Method many = in_double(method);
    many.samples = 64;
    parts.push_back({"filter and samples", "colour", predicted.filter,
                     largest_difference(drawn, bench.draw(many), pixels)});
    measure::Method one = bilinear;
    one.samples = 1;
    parts.push_back({"precision", "colour", predicted.precision,
                     largest_difference(bench.draw(one), bench.draw(in_double(one)), pixels)});
  }
  return parts;
}

std::vector<Attribution> attribute(const measure::Method& closest, const Candidates& candidates,
                                   const ToleranceChecker& checker, measure::MethodBench& bench) {
  const double color = checker.tolerance().color;
  const auto fails = [&](float error) { return !(error <= color); };
  const PixelErrors closest_errors = checker.check_all(bench.draw(closest));
  const bool in_place = closest_errors.total.failing == 0;  // only the demanded share is missed
  const Grid<float> PixelErrors::* judged =
      in_place ? &PixelErrors::in_place : &PixelErrors::errors;
  const Grid<float>& errors = closest_errors.*judged;
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < errors.pixels.size(); ++i) {
    if (fails(errors.pixels[i])) left.push_back(i);
  }
  std::vector<Attribution> all;
  const auto put = [&](const std::string& part, const auto& is_its) {
    const auto count = std::erase_if(left, is_its);
    if (count > 0) all.push_back({part, static_cast<long long>(count)});
  };
  for (const Mended& m : mended(closest, candidates)) {
    if (left.empty()) break;
    const Grid<float> now = checker.check_all(bench.draw(m.method)).*judged;
    put(m.part, [&](std::size_t i) { return !fails(now.pixels[i]); });
  }
  const Grid<SeenPlace> places = places_of(checker.fragments());
  const std::size_t width = std::size_t(places.width);
  put("edges", [&](std::size_t i) { return !is_inside(places, int(i % width), int(i / width)); });
  put("several parts together", [](std::size_t) { return true; });
  std::ranges::stable_sort(all, std::ranges::greater{}, &Attribution::pixels);
  return all;
}

}  // namespace lumaknot::plan
