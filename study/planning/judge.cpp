#include "study/planning/judge.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "scene/error.h"
#include "study/method.h"
#include "study/nothing_seen.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

/// Means over pixels are known to an eighth of the tolerance.
double mean_error(const Tolerance& tolerance) {
  return std::max(tolerance.color, kAreaTruthError) / 8;
}

Scene with_true_material(Scene scene) {
  scene.mesh = {};  // rays meet the exact surface
  Material& material = scene.view.material;
  material = true_material(material, material.space);
  return scene;
}

Sample sample_of(const RgbaPixel& pixel) { return {to_vec(pixel.color), pixel.coverage}; }

SampleRange range_about(const Sample& sample, double error) {
  constexpr double kFar = 1e30;
  SampleRange range{{{kFar, kFar, kFar}, kFar}, {{-kFar, -kFar, -kFar}, -kFar}};
  range.add(sample, error);
  return range;
}

std::unique_ptr<NearbyRange> nearby_range(const Sample& sample, double error) {
  const SampleRange range = range_about(sample, error);
  return std::make_unique<NearbyRange>(
      NearbyRange{.place = range, .coarse = {}, .quick = {}, .full = {}, .behind = {}});
}

template <class F>
void each(std::span<const std::size_t> pixels, const F& work) {
  constexpr std::size_t kAsked = 64;  // pixels: asking takes as long as a look in place
  oneapi::tbb::parallel_for(std::size_t{0}, pixels.size(), [&](std::size_t k) {
    if (k % kAsked == 0) check_interrupted();
    work(pixels[k]);
  });
}

constexpr int kLooks = 3;  // coarse, quick, full

/// The last `count` of `heap`, its worst, taken from it.
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

Judge::Judge(Scene scene, const KnotSpec& knot, const Tolerance& tolerance,
             const Progress& progress)
    : scene_(with_true_material(std::move(scene))),
      tolerance_(tolerance),
      area_(scene_.view.image.samples > 1),
      pixels_(scene_, knot),
      nearby_(pixels_, knot.tube_radius, tolerance.shift, area_),
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
    throw Error(kNothingSeen);
  }
}

void Judge::look_at_centres() {
  fragments_ = Grid<ExactFragment>(truth_.width, truth_.height);
  oneapi::tbb::parallel_for(0, truth_.height, [&](int y) {
    check_interrupted();
    for (int x = 0; x < truth_.width; ++x) fragments_.at(x, y) = pixels_.at(x + 0.5, y + 0.5);
  });
}

void Judge::take_centres() {
  std::vector<std::size_t> all(fragments_.pixels.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  each(all, [&](std::size_t i) {
    const Fragment& seen = fragments_.pixels[i].fragment;
    if (!seen.covered()) return;
    const Sample sample = pixels_.sample(seen);
    truth_.pixels[i] = {to_rgb(sample.color), 1};
    ranges_[i] = nearby_range(sample, 0);
  });
}

void Judge::take_means(const Progress& progress) {
  int done = 0;
  for (int y = 0; y < truth_.height; y += 16) {  // told between bands, from one thread
    const int end = std::min(y + 16, truth_.height);
    oneapi::tbb::parallel_for(y, end, [&](int row) {
      check_interrupted();
      const std::vector<PixelTruth> means =
          area_row(pixels_, row, truth_.width, mean_error(tolerance_));
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
std::vector<Judge::Suspect> Judge::suspects(const Image& picture, PixelErrors& result) const {
  std::vector<Suspect> far;
  ToleranceResult& judgement = result.judgement;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if (picture.pixels[i].coverage == 0 && truth_.pixels[i].coverage == 0) continue;
    ++judgement.covered;
    const Sample sample = sample_of(picture.pixels[i]);
    const double error = range_about(sample_of(truth_.pixels[i]), 0).distance(sample);
    judgement.in_place = std::max(judgement.in_place, error);
    judgement.mean_in_place += error;
    result.in_place.pixels[i] = float(error);
    if (!(error <= tolerance_.color)) ++judgement.shifted;
    if (!ranges_[i]) ranges_[i] = nearby_range({}, 0);
    const double most = ranges_[i]->place.distance(sample);
    result.errors.pixels[i] = float(most);
    if (!(most <= tolerance_.color)) far.push_back({.pixel = i, .error = most});
  }
  if (judgement.covered > 0) judgement.mean_in_place /= double(judgement.covered);
  std::ranges::make_heap(far, {}, &Suspect::error);
  return far;
}

void Judge::look_closer(Suspect& suspect, const Sample& sample) const {
  NearbyRange& nearby = *ranges_[suspect.pixel];
  const int x = int(suspect.pixel) % truth_.width, y = int(suspect.pixel) / truth_.width;
  switch (++suspect.looks) {
    case 1:
      nearby_.look_coarsely(nearby, x, y);
      suspect.error = nearby.coarse.distance(sample);
      return;
    case 2:
      nearby_.look_quickly(nearby, x, y);
      suspect.error = nearby.quick.distance(sample);
      return;
    default:
      nearby_.look_fully(nearby, x, y);
      suspect.error = nearby.full.distance(sample);
  }
  if (suspect.error <= tolerance_.color) return;
  suspect.error = nearby.behind.distance(sample);
  suspect.hidden = suspect.error <= tolerance_.color;
}

/// Always the worst pixels first, and closer only where that decides.
PixelErrors Judge::examine(const Image& picture, bool all) const {
  constexpr std::size_t kChunk = 64;
  const Grid<float> none(picture.width, picture.height);
  PixelErrors result{{}, none, none};
  ToleranceResult& judgement = result.judgement;
  std::vector<Suspect> far = suspects(picture, result);
  double worst = 0;  // of those that fail
  while (!far.empty()) {
    if (!all && judgement.failing > kFar && far.front().error <= worst) break;
    check_interrupted();
    std::vector<Suspect> chunk = take_worst(far, kChunk);
    oneapi::tbb::parallel_for(std::size_t{0}, chunk.size(), [&](std::size_t k) {
      look_closer(chunk[k], sample_of(picture.pixels[chunk[k].pixel]));
    });
    for (const Suspect& suspect : chunk) {
      result.errors.pixels[suspect.pixel] = float(suspect.error);
      judgement.hidden += suspect.hidden;
      if (suspect.error <= tolerance_.color) continue;
      if (suspect.looks == kLooks) {
        ++judgement.failing;
        worst = std::max(worst, suspect.error);
        continue;
      }
      far.push_back(suspect);
      std::ranges::push_heap(far, {}, &Suspect::error);
    }
  }
  judgement.met = judgement.failing == 0;
  judgement.error = *std::ranges::max_element(result.errors.pixels);
  return result;
}

ToleranceResult Judge::judge(const Image& picture) const {
  return examine(picture, false).judgement;
}

PixelErrors Judge::judge_all(const Image& picture) const { return examine(picture, true); }

}  // namespace lumaknot
