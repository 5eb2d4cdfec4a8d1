#include "study/planning/judge.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
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
      NearbyRange{.place = range, .quick = {}, .full = {}, .behind = {}});
}

template <class F>
void each(std::span<const std::size_t> pixels, const F& work) {
  constexpr std::size_t kAsked = 64;  // pixels: asking takes as long as a look in place
  oneapi::tbb::parallel_for(std::size_t{0}, pixels.size(), [&](std::size_t k) {
    if (k % kAsked == 0) check_interrupted();
    work(pixels[k]);
  });
}

/// The pixels in `order` by falling error.
std::vector<std::size_t> worst_first(std::vector<std::size_t> order, const Grid<float>& errors) {
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](std::size_t i) { return errors.pixels[i]; });
  return order;
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

double Judge::quick_error(std::size_t pixel, const Sample& sample) const {
  std::unique_ptr<NearbyRange>& nearby = ranges_[pixel];
  if (!nearby) nearby = nearby_range({}, 0);
  const double in_place = nearby->place.distance(sample);
  if (in_place <= tolerance_.color) return in_place;
  const int width = truth_.width;
  nearby_.look_quickly(*nearby, int(pixel) % width, int(pixel) / width);
  return nearby->quick.distance(sample);
}

Judge::Found Judge::full_error(std::size_t pixel, const Sample& sample) const {
  NearbyRange& nearby = *ranges_[pixel];
  const int width = truth_.width;
  nearby_.look_fully(nearby, int(pixel) % width, int(pixel) / width);
  const double seen = nearby.full.distance(sample);
  if (seen <= tolerance_.color) return {seen, false};
  const double behind = nearby.behind.distance(sample);
  return {behind, behind <= tolerance_.color};
}

PixelErrors Judge::examine(const Image& picture, bool all) const {
  const Grid<float> none(picture.width, picture.height);
  PixelErrors result{{}, none, none};
  Judgement& judgement = result.judgement;
  std::vector<std::size_t> far;  // in place
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if (picture.pixels[i].coverage == 0 && truth_.pixels[i].coverage == 0) continue;
    ++judgement.covered;
    const double error =
        range_about(sample_of(truth_.pixels[i]), 0).distance(sample_of(picture.pixels[i]));
    judgement.in_place = std::max(judgement.in_place, error);
    judgement.mean_in_place += error;
    result.in_place.pixels[i] = float(error);
    far.push_back(i);
    if (!(error <= tolerance_.color)) ++judgement.shifted;
  }
  if (judgement.covered > 0) judgement.mean_in_place /= double(judgement.covered);
  std::atomic<long long> hidden = 0;
  each(far, [&](std::size_t i) {
    result.errors.pixels[i] = float(quick_error(i, sample_of(picture.pixels[i])));
  });
  const auto beyond = [&](std::size_t i) { return !(result.errors.pixels[i] <= tolerance_.color); };
  std::erase_if(far, [&](std::size_t i) { return !beyond(i); });
  far = worst_first(std::move(far), result.errors);
  constexpr std::size_t kChunk = 256;
  for (std::size_t begin = 0; begin < far.size(); begin += kChunk) {
    const auto chunk = std::span(far).subspan(begin, std::min(kChunk, far.size() - begin));
    each(chunk, [&](std::size_t i) {
      const Found found = full_error(i, sample_of(picture.pixels[i]));
      result.errors.pixels[i] = float(found.error);
      hidden += found.hidden;
    });
    judgement.failing += std::ranges::count_if(chunk, beyond);
    if (!all && judgement.failing > 0) break;
  }
  judgement.hidden = hidden;
  judgement.met = judgement.failing == 0;
  for (std::size_t i = 0; i < result.errors.pixels.size(); ++i) {
    judgement.error = std::max(judgement.error, double(result.errors.pixels[i]));
  }
  return result;
}

Judgement Judge::judge(const Image& picture) const { return examine(picture, false).judgement; }

PixelErrors Judge::judge_all(const Image& picture) const { return examine(picture, true); }

}  // namespace lumaknot
