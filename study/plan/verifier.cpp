#include "study/plan/verifier.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "study/measure/empty_scene.h"
#include "study/measure/method.h"
#include "system/error.h"
#include "system/process.h"

namespace lumaknot::plan {
namespace {

/// Means over pixels are known to an eighth of the tolerance.
double mean_error(const Tolerance& tolerance) {
  return std::max(tolerance.color, kAreaTruthError) / 8;
}

Scene with_true_material(Scene scene) {
  scene.mesh = {};  // rays meet the exact surface
  Material& material = scene.view.material;
  material = measure::true_material(material, material.space);
  return scene;
}

exact::Sample sample_of(const RgbaPixel& pixel) { return {to_vec(pixel.color), pixel.coverage}; }

SampleRange range_about(const exact::Sample& sample, double error) {
  constexpr double kFar = 1e30;
  SampleRange range{{{kFar, kFar, kFar}, kFar}, {{-kFar, -kFar, -kFar}, -kFar}};
  range.add(sample, error);
  return range;
}

std::unique_ptr<NeighborhoodRange> nearby_range(const exact::Sample& sample, double error) {
  const SampleRange range = range_about(sample, error);
  return std::make_unique<NeighborhoodRange>(
      NeighborhoodRange{.place = range, .coarse = {}, .quick = {}, .full = {}, .behind = {}});
}

template <class F>
void each(std::span<const std::size_t> pixels, const F& work) {
  constexpr std::size_t kAsked = 64;  // pixels: a check takes as long as a look in place
  oneapi::tbb::parallel_for(std::size_t{0}, pixels.size(), [&](std::size_t k) {
    if (k % kAsked == 0) check_interrupted();
    work(pixels[k]);
  });
}

/// The pixels that must be within the tolerance in place for `share` of all, and are not.
long long lacking_in_place(const ToleranceResult& result, double share) {
  constexpr double kSlack = 1e-6;  // of a product of doubles, for up to 1e9 pixels
  const auto demanded = (long long)(std::ceil(share * double(result.covered) - kSlack));
  return std::max(0LL, demanded - result.met_in_place());
}

constexpr int kLooks = 3;  // coarse, quick, full

/// Takes the last `count` of `heap`, its worst, out of it.
template <class Suspect>
std::vector<Suspect> take_worst(std::vector<Suspect>& heap, std::size_t count) {
  std::vector<Suspect> worst;
  while (!heap.empty() && worst.size() < count) {
    std::ranges::pop_heap(heap, {}, &Suspect::error);
    worst.push_back(heap.back());
    heap.pop_back();
  }
  return worst;
}

}  // namespace

ToleranceChecker::ToleranceChecker(Scene scene, const KnotSpec& knot, const Tolerance& tolerance,
                                   const Progress& progress)
    : scene_(with_true_material(std::move(scene))),
      tolerance_(tolerance),
      area_(scene_.view.image.samples > 1),
      pixels_(scene_, knot),
      neighborhood_(pixels_, knot.tube_radius, tolerance.shift, area_),
      truth_(scene_.view.image.width, scene_.view.image.height),
      ranges_(truth_.pixels.size()) {
  look_at_centres();
  if (area_) {
    take_means(progress);
  } else {
    take_centres();
  }
  const auto covered = [](const RgbaPixel& p) { return p.coverage > 0; };
  if (std::ranges::none_of(truth_.pixels, covered)) {
    throw Error(measure::kNothingSeen);
  }
}

void ToleranceChecker::look_at_centres() {
  fragments_ = Grid<exact::ExactFragment>(truth_.width, truth_.height);
  oneapi::tbb::parallel_for(0, truth_.height, [&](int y) {
    check_interrupted();
    for (int x = 0; x < truth_.width; ++x) fragments_.at(x, y) = pixels_.at(x + 0.5, y + 0.5);
  });
}

void ToleranceChecker::take_centres() {
  std::vector<std::size_t> all(fragments_.pixels.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  each(all, [&](std::size_t i) {
    const Fragment& seen = fragments_.pixels[i].fragment;
    if (!seen.covered()) return;
    const exact::Sample sample = pixels_.sample(seen);
    truth_.pixels[i] = {to_rgb(sample.color), 1};
    ranges_[i] = nearby_range(sample, 0);
  });
}

void ToleranceChecker::take_means(const Progress& progress) {
  int done = 0;
  for (int y = 0; y < truth_.height; y += 16) {  // reported between bands, from one thread
    const int end = std::min(y + 16, truth_.height);
    oneapi::tbb::parallel_for(y, end, [&](int row) {
      check_interrupted();
      const std::vector<exact::PixelTruth> means =
          exact::area_row(pixels_, row, truth_.width, mean_error(tolerance_));
      for (int x = 0; x < truth_.width; ++x) {
        const auto& [sample, error] = means[std::size_t(x)];
        truth_.at(x, row) = {to_rgb(sample.color), float(sample.coverage)};
        if (sample.coverage == 0) continue;
        const std::size_t i = std::size_t(row) * std::size_t(truth_.width) + std::size_t(x);
        ranges_[i] = nearby_range(sample, error);
      }
    });
    done = end;
    if (progress) progress(double(done) / truth_.height);
  }
}

/// The pixels beyond the tolerance in place, as a heap; counts those that are covered.
std::vector<ToleranceChecker::Suspect> ToleranceChecker::suspects(const Image& picture,
                                                                  PixelErrors& result) const {
  std::vector<Suspect> far;
  ToleranceResult& total = result.total;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if (picture.pixels[i].coverage == 0 && truth_.pixels[i].coverage == 0) continue;
    ++total.covered;
    const exact::Sample sample = sample_of(picture.pixels[i]);
    const double error = range_about(sample_of(truth_.pixels[i]), 0).distance(sample);
    total.in_place = std::max(total.in_place, error);
    total.mean_in_place += error;
    result.in_place.pixels[i] = float(error);
    if (!(error <= tolerance_.color)) ++total.shifted;
    if (!ranges_[i]) ranges_[i] = nearby_range({}, 0);
    const double max = ranges_[i]->place.distance(sample);
    result.errors.pixels[i] = float(max);
    if (!(max <= tolerance_.color)) far.push_back({.pixel = i, .error = max});
  }
  if (total.covered > 0) total.mean_in_place /= double(total.covered);
  std::ranges::make_heap(far, {}, &Suspect::error);
  return far;
}

void ToleranceChecker::look_closer(Suspect& suspect, const exact::Sample& sample) const {
  NeighborhoodRange& neighborhood = *ranges_[suspect.pixel];
  const int x = int(suspect.pixel) % truth_.width, y = int(suspect.pixel) / truth_.width;
  switch (++suspect.looks) {
    case 1:
      neighborhood_.look_coarsely(neighborhood, x, y);
      suspect.error = neighborhood.coarse.distance(sample);
      return;
    case 2:
      neighborhood_.look_quickly(neighborhood, x, y);
      suspect.error = neighborhood.quick.distance(sample);
      return;
    default:
      neighborhood_.look_fully(neighborhood, x, y);
      suspect.error = neighborhood.full.distance(sample);
  }
  if (suspect.error <= tolerance_.color) return;
  suspect.error = neighborhood.behind.distance(sample);
  suspect.hidden = suspect.error <= tolerance_.color;
}

/// Always the worst pixels first, and closer only if that decides.
PixelErrors ToleranceChecker::examine(const Image& picture, bool all) const {
  constexpr std::size_t kSuspects = 64;
  const Grid<float> none(picture.width, picture.height);
  PixelErrors result{{}, none, none};
  ToleranceResult& total = result.total;
  std::vector<Suspect> far = suspects(picture, result);
  double worst = 0;  // of those that fail
  while (!far.empty()) {
    if (!all && total.failing > ToleranceResult::kFar && far.front().error <= worst) break;
    check_interrupted();
    std::vector<Suspect> chunk = take_worst(far, kSuspects);
    oneapi::tbb::parallel_for(std::size_t{0}, chunk.size(), [&](std::size_t k) {
      look_closer(chunk[k], sample_of(picture.pixels[chunk[k].pixel]));
    });
    for (const Suspect& suspect : chunk) {
      result.errors.pixels[suspect.pixel] = float(suspect.error);
      total.hidden += suspect.hidden;
      if (suspect.error <= tolerance_.color) continue;
      if (suspect.looks == kLooks) {
        ++total.failing;
        worst = std::max(worst, suspect.error);
        continue;
      }
      far.push_back(suspect);
      std::ranges::push_heap(far, {}, &Suspect::error);
    }
  }
  total.lacking = lacking_in_place(total, tolerance_.in_place);
  total.met = total.failing == 0 && total.lacking == 0;
  total.error = *std::ranges::max_element(result.errors.pixels);
  return result;
}

ToleranceResult ToleranceChecker::check(const Image& picture) const {
  return examine(picture, false).total;
}

PixelErrors ToleranceChecker::check_all(const Image& picture) const {
  return examine(picture, true);
}

}  // namespace lumaknot::plan
