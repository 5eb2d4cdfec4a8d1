#include "study/paper/reproduction.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "study/measure/fingerprint.h"
#include "study/paper/appearance_claims.h"
#include "study/paper/checkpoint.h"
#include "study/paper/formula_claims.h"
#include "study/paper/listing_claims.h"
#include "study/paper/outlook_claims.h"
#include "study/paper/speed_claims.h"
#include "system/process.h"

namespace lumaknot::paper {
namespace {

namespace fs = std::filesystem;

// The shares of the work at which each part ends.
constexpr double kFiguresEnd = 0.35, kTimesEnd = 0.42, kClaimsEnd = 0.55;

/// Maps a part's progress into the whole's.
Progress part_of(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [=](double share) { progress(begin + (end - begin) * share); };
}

/// Identifies the program, size and renderers of kept pictures.
std::string key_of(const PaperJob& job) {
  return fmt::format("{} {} {} {}", measure::program_key(), job.side,
                     job.programs.path(validate::kBlenderProgram),
                     job.programs.path(validate::kPovrayProgram));
}

/// Both lights' pictures; each is kept in `folder` as soon as it is drawn, and read from there.
Figures draw_figures(const PaperScenes& scenes, const PaperJob& job, const fs::path& folder,
                     const Progress& progress) {
  std::vector<LightPictures> lights;
  double done = 0;
  for (const FigureLight light : {FigureLight::kFront, FigureLight::kBack}) {
    std::optional<LightPictures> drawn = kept_light(folder, light, key_of(job));
    if (!drawn) {
      drawn = draw_light(scenes, light, job.programs, [&] {
        done += 0.25;  // two renderers for each of two lights
        if (progress) progress(done);
      });
      keep_light(*drawn, folder, light, key_of(job));
    }
    lights.push_back(std::move(*drawn));
  }
  return figures_of(lights[0], lights[1]);
}

void append(std::vector<PaperClaim>& claims, std::vector<PaperClaim> more) {
  std::ranges::move(more, std::back_inserter(claims));
  check_interrupted();
}

}  // namespace

PaperResult reproduce_paper(const PaperJob& job, const std::filesystem::path& folder,
                            const Progress& progress) {
  PaperResult result;
  result.side = job.side;
  const PaperScenes scenes = paper_scenes(job.side);
  result.figures = draw_figures(scenes, job, folder, part_of(progress, 0, kFiguresEnd));
  const std::vector<FormulaTime> times =
      time_formulas(scenes.front, timed_formulas(), job.formula_seconds,
                    part_of(progress, kFiguresEnd, kTimesEnd));
  const Progress claims_done = part_of(progress, kTimesEnd, kClaimsEnd);
  const auto report = [&](double share) {
    if (claims_done) claims_done(share);
  };
  append(result.claims, formula_claims(scenes));
  report(0.25);
  append(result.claims, listing_claims(scenes));
  report(0.5);
  append(result.claims, look_claims(scenes));
  report(0.75);
  append(result.claims, outlook_claims(scenes, times));
  result.rates = bench::measure_rates(scenes.front, job.rates, part_of(progress, kClaimsEnd, 1));
  append(result.claims, speed_claims(scenes, result.rates, times));
  std::ranges::stable_sort(result.claims, {}, &PaperClaim::section);
  return result;
}

int checkpointed_lights(const PaperJob& job, const std::filesystem::path& folder) {
  return checkpointed_lights(folder, key_of(job));
}

}  // namespace lumaknot::paper
