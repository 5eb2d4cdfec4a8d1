#include "validate/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "system/error.h"
#include "validate/compare/noise_words.h"
#include "validate/compare/quantile.h"
#include "validate/renderers/entry.h"
#include "validate/renderers/external.h"

namespace lumaknot::validate {
namespace {

using Message = std::function<void(const std::string&)>;
using Clock = std::chrono::steady_clock;

/// Pictures of every shot, with two seeds.
using TwoRenderings = std::array<Rendering, 2>;

/// Throws Error if they were to be denoised by a program that can't.
void check_denoised(const Sampling& sampling, const Rendering& drawn) {
  if (!sampling.denoised || drawn.log.find("without OpenImageDenoise") == std::string::npos) return;
  throw Error(fmt::format(
      "--denoise: {} is built without OpenImageDenoise; give another --blender, or no --denoise",
      line_with(drawn.log, "Blender ")));
}

TwoRenderings draw_twice(const ValidationJob& job, const std::vector<Shot>& shots,
                         const RendererEntry& renderer, Sampling sampling,
                         const Message& on_message) {
  TwoRenderings two;
  for (Rendering& drawn : two) {
    drawn = renderer.sampling->make(job.programs, sampling)->draw(job.scene, shots);
    check_denoised(sampling, drawn);
    if (on_message) {
      on_message(fmt::format("{}, seed {}{}: {:.1f} s", renderer.name, sampling.seed,
                             sampling.denoised ? ", denoised" : "", drawn.seconds));
    }
    ++sampling.seed;
  }
  return two;
}

/// So many samples of ours for each of theirs: our own error is then about a tenth of theirs.
constexpr int kOversampling = 8;
constexpr int kMaxOwnSamples = 8192;

/// What a renderer's picture of the shot is on average; `centred` is our picture of it with one
/// sample in each pixel's centre.
FilteredImage expectation(const Scene& scene, const Shot& shot, const Image& centred,
                          const SamplingEntry& entry, int samples) {
  FilteredImage image =
      render_filtered(scene, shot, entry.filter, std::min(kOversampling * samples, kMaxOwnSamples));
  if (!entry.first_is_centred) return image;
  for (Grid<Channels>& half : image.halves) {
    for (std::size_t i = 0; i < half.pixels.size(); ++i) {
      const RgbaPixel& first = centred.pixels[i];
      const Channels fixed{first.color.r, first.color.g, first.color.b, first.coverage};
      for (std::size_t c = 0; c < fixed.size(); ++c) {
        half.pixels[i][c] += (fixed[c] - half.pixels[i][c]) / samples;
      }
    }
  }
  return image;
}

Image expected_image(const FilteredImage& expected) {
  const Grid<Channels>&a = expected.halves[0], &b = expected.halves[1];
  Image image(a.width, a.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Channels &p = a.pixels[i], &q = b.pixels[i];
    image.pixels[i] = {to_rgb(Vec3d{p[0] + q[0], p[1] + q[1], p[2] + q[2]} / 2),
                       float((p[3] + q[3]) / 2)};
  }
  return image;
}

Image mean_image(const Image& a, const Image& b) {
  Image image(a.width, a.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const RgbaPixel &p = a.pixels[i], &q = b.pixels[i];
    image.pixels[i] = {to_rgb((to_vec(p.color) + to_vec(q.color)) / 2),
                       (p.coverage + q.coverage) / 2};
  }
  return image;
}

/// The statistics of errors that every comparison has, of the mean of both pictures.
Comparison errors_of(const Image& ours, const Image& theirs) {
  Comparison result;
  std::vector<double> errors;
  double sum = 0, squares = 0;
  for (int y = 0; y < ours.height; ++y) {
    for (int x = 0; x < ours.width; ++x) {
      const RgbaPixel& mine = ours.at(x, y);
      if (mine.coverage <= 0) continue;
      const double error = channel_error(to_vec(mine.color), theirs.at(x, y).color, false);
      errors.push_back(error);
      sum += error;
      squares += error * error;
      if (error > result.max) result.max = error, result.max_at = {x, y};
    }
  }
  const double count = std::max(1.0, double(errors.size()));
  result.covered = result.inside = (long long)errors.size();
  result.mean = result.mean_unclassed = sum / count;
  result.rmse = std::sqrt(squares / count);
  result.p99 = quantile(errors, 0.99);
  result.p999 = result.p999_unclassed = quantile(errors, 0.999);
  result.p9999 = result.p9999_unclassed = quantile(errors, 0.9999);
  return result;
}

bool is_drawn(const RenderedShot& shot) { return shot.status == RenderedShot::Status::kDrawn; }

/// A shot's pictures by the renderer, and what they are held to.
struct DrawnPair {
  const RenderedShot &first, &second;
  const FilteredImage& expected;
  const Image& ours;  ///< the expectation
  int samples;
  double family_error;
  std::size_t budget;  ///< bytes of a renderer's picture in the report
};

Judged judge_pair(const DrawnPair& pair) {
  Judged judged;
  const Image theirs = mean_image(pair.first.image, pair.second.image);
  judged.noise = test_noise({pair.first.image, pair.second.image, pair.expected, pair.samples},
                            pair.family_error);
  judged.comparison = errors_of(pair.ours, theirs);
  judged.comparison.coverage_differs = judged.noise.exceeded(true);
  judged.comparison.coverage_unexplained = judged.noise.exceeded(true);
  for (std::size_t i = 0; i < judged.noise.scales.size(); ++i) {
    if (judged.noise.scales[i].exceeded == 0) continue;
    judged.comparison.exceeded.push_back(finding_text(judged.noise, i));
  }
  judged.pictures = pictures_of({pair.ours, theirs, false}, judged.noise.marks, pair.budget);
  judged.noise.marks = {};
  judged.drawn.status = RenderedShot::Status::kDrawn;
  return judged;
}

/// What both renderings have in common, without shots.
RendererResult result_of(const RendererEntry& renderer, const TwoRenderings& two) {
  RendererResult result;
  Rendering& rendering = result.rendering;
  const Rendering& first = two[0];
  rendering.renderer = first.renderer;
  rendering.version = first.version;
  rendering.command = first.command;
  rendering.log = first.log;
  rendering.seconds = first.seconds + two[1].seconds;
  result.promise = promise_of(renderer, first.version);
  return result;
}

void add_shot(Judged judged, RendererResult& result) {
  result.coverage_differs = std::max(result.coverage_differs, judged.comparison.coverage_differs);
  result.coverage_unexplained = result.coverage_differs;
  result.shots.push_back(std::move(judged));
}

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

/// Judges the renderer's pictures, shot by shot: an expectation takes much memory.
class NoiseJudge {
 public:
  NoiseJudge(const ValidationJob& job, const RendererEntry& renderer, const Sampling& sampling,
             Validation& validation)
      : job_(job), renderer_(renderer), sampling_(sampling), validation_(validation) {}

  /// Of the shot's pictures; replaces ours by the expectation if both are drawn.
  Judged judge(std::size_t shot, const TwoRenderings& drawn, const TwoRenderings* denoised) const {
    const RenderedShot &first = drawn[0].shots[shot], &second = drawn[1].shots[shot];
    Image& ours = validation_.own.shots[shot].image;
    Judged judged;
    if (!is_drawn(first) || !is_drawn(second)) {
      judged.drawn = is_drawn(first) ? second : first;
      judged.drawn.image = {};
      return judged;
    }
    const FilteredImage expected = expectation(job_.scene, validation_.shots[shot], ours,
                                               *renderer_.sampling, sampling_.samples);
    ours = expected_image(expected);
    const std::size_t shots = validation_.shots.size();
    judged = judge_pair({first, second, expected, ours, sampling_.samples,
                         kFamilyError / double(shots), picture_budget(shots)});
    if (denoised) {
      judged.denoised =
          denoised_errors({first.image, second.image, expected, sampling_.samples},
                          (*denoised)[0].shots[shot].image, (*denoised)[1].shots[shot].image);
    }
    return judged;
  }

 private:
  const ValidationJob& job_;
  const RendererEntry& renderer_;
  Sampling sampling_;
  Validation& validation_;
};

/// Whether all pictures are there.
bool are_drawn(const TwoRenderings& two) {
  return std::ranges::all_of(
      two, [](const Rendering& drawn) { return std::ranges::all_of(drawn.shots, is_drawn); });
}

}  // namespace

Validation validate_noise(const ValidationJob& job, const RendererEntry& renderer,
                          const Sampling& sampling, const Message& on_message) {
  const auto start = Clock::now();
  Validation result;
  result.sampling = sampling;
  result.shots = shots_of(job);
  const Grid<Fragment> fragments = visible_fragments(job.scene);
  if (std::ranges::none_of(fragments.pixels, &Fragment::covered)) {
    throw Error("the camera sees nothing of the mesh; move camera.position or camera.target");
  }
  std::optional<TwoRenderings> denoised;
  if (sampling.denoised) {
    denoised = draw_twice(job, result.shots, renderer, sampling, on_message);
  }
  const Sampling noisy{sampling.samples, sampling.seed};
  const TwoRenderings drawn = draw_twice(job, result.shots, renderer, noisy, on_message);
  RendererResult judged = result_of(renderer, drawn);
  result.own = own_renderer(fragments)->draw(job.scene, result.shots);
  const NoiseJudge judge(job, renderer, sampling, result);
  for (std::size_t i = 0; i < result.shots.size(); ++i) {
    const auto shot_start = Clock::now();
    const bool is_denoised = denoised && are_drawn(*denoised);
    add_shot(judge.judge(i, drawn, is_denoised ? &*denoised : nullptr), judged);
    result.own_pictures.push_back(
        own_picture(result.own.shots[i].image, picture_budget(result.shots.size())));
    const double seconds = seconds_since(shot_start);
    result.own.seconds += seconds;
    if (on_message) {
      on_message(fmt::format("lumaknot, {}: {:.1f} s", result.shots[i].name, seconds));
    }
  }
  result.own_claims.resize(result.shots.size());
  result.own_cover = cover_png(Reference(job.scene, fragments));
  result.results.push_back(std::move(judged));
  conclude(result);
  result.seconds = seconds_since(start);
  return result;
}

}  // namespace lumaknot::validate
