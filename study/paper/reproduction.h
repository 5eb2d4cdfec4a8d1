/// The whole paper reproduced: its figures, its claims, its table.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/bench/frame_rates.h"
#include "study/paper/claim.h"
#include "study/paper/figures.h"
#include "study/paper/formula_times.h"

namespace lumaknot::paper {

struct PaperJob {
  int side = 720;  ///< of the pictures, in pixels
  validate::Programs programs;
  bench::RateOptions rates;
  double formula_seconds = 4;  ///< of timing formulas
};

/// The contents of the page.
struct PaperResult {
  int side = 0;
  Figures figures;
  std::vector<PaperClaim> claims;  ///< in the paper's order
  bench::RateTable rates;
};

/// Draws and measures everything. The figures' images are written into `folder` as soon as they are
/// drawn, and those that an interrupted run left there are not drawn again. Throws Interrupted, and
/// Error if a file can't be written.
PaperResult reproduce_paper(const PaperJob& job, const std::filesystem::path& folder,
                            const Progress& progress = {});

/// The number of lights whose pictures in `folder` reproduce_paper() would not draw again.
int checkpointed_lights(const PaperJob& job, const std::filesystem::path& folder);

/// One HTML page that needs nothing else.
std::string paper_html(const PaperResult& result);

/// The same numbers as JSON, two spaces deep, ending in a newline.
std::string paper_json(const PaperResult& result);

/// Each claim's verdict, as text for a terminal.
std::string paper_text(const PaperResult& result);

}  // namespace lumaknot::paper
