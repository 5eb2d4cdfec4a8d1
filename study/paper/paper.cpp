#include "study/paper/paper.h"

#include <algorithm>
#include <iterator>

#include "scene/atomic_file.h"
#include "study/paper/formula_claims.h"
#include "study/paper/listing_claims.h"
#include "study/paper/look_claims.h"
#include "study/paper/outlook_claims.h"
#include "study/paper/speed_claims.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

// The shares of the work at which each part ends.
constexpr double kFiguresEnd = 0.35, kTimesEnd = 0.42, kClaimsEnd = 0.55;

/// Maps a part's progress into the whole's.
Progress part_of(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [=](double share) { progress(begin + (end - begin) * share); };
}

void write_images(const Figures& figures, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "images");
  for (const auto* pictures : {&figures.figure1, &figures.figure2}) {
    for (const FigurePicture& picture : *pictures) {
      for (const FigureImage& image : picture.images) {
        if (!image.file.empty()) write_file(folder / image.file, image.png, "--output");
      }
    }
  }
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
  result.figures = draw_figures(scenes, job.programs, part_of(progress, 0, kFiguresEnd));
  write_images(result.figures, folder);
  const std::vector<FormulaTime> times =
      time_formulas(scenes.front, timed_formulas(), job.formula_seconds,
                    part_of(progress, kFiguresEnd, kTimesEnd));
  const Progress claims_done = part_of(progress, kTimesEnd, kClaimsEnd);
  const auto told = [&](double share) {
    if (claims_done) claims_done(share);
  };
  append(result.claims, formula_claims(scenes));
  told(0.25);
  append(result.claims, listing_claims(scenes, job.programs));
  told(0.5);
  append(result.claims, look_claims(scenes));
  told(0.75);
  append(result.claims, outlook_claims(scenes, times));
  result.rates = measure_rates(scenes.front, job.rates, part_of(progress, kClaimsEnd, 1));
  append(result.claims, speed_claims(scenes, result.rates, times));
  std::ranges::stable_sort(result.claims, {}, &PaperClaim::section);
  return result;
}

}  // namespace lumaknot
