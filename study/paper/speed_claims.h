/// What sections 5 and 6 claim of the mesh and of speed.
#pragma once

#include <span>
#include <vector>

#include "study/frame_rates.h"
#include "study/paper/claim.h"
#include "study/paper/formula_times.h"
#include "study/paper/paper_scenes.h"
#include "study/rate_report.h"

namespace lumaknot {

PaperClaim grid_claim(long long vertices, long long triangles);

/// Table 2, its rows as paper_rows() has them, against what the text says of it.
PaperClaim table_claim(std::span<const PaperRow> rows);

PaperClaim slower_claim(std::span<const RateRow> rows);
PaperClaim cost_claim(std::span<const RateRow> rows, std::span<const PaperRow> paper);
PaperClaim real_time_claim(std::span<const RateRow> rows);
PaperClaim glsl_speed_claim(std::span<const RateRow> rows, std::span<const PaperRow> paper,
                            std::span<const MissingRates> missing);

/// The forms of YIQ: slots of the pixel shader and times on one thread.
struct Forms {
  int rgb_slots = 0, matrices_slots = 0, collapsed_slots = 0, baked_slots = 0;
  std::vector<FormulaTime> times;  ///< of "rgb-phong", "yiq-phong", "yiq-collapsed-phong", ...
  double collapsed_differs = 0;    ///< largest difference of its picture from the matrices'
};

PaperClaim fast_conversion_claim(const Forms& forms);
PaperClaim half_claim(const Forms& forms);
PaperClaim most_efficient_claim(const Forms& forms);
PaperClaim rgb_output_claim(const Forms& forms);
PaperClaim collapsed_claim(const Forms& forms);
PaperClaim no_compromise_claim(const Forms& forms);

/// The time of `formula`, which is among `times`.
const FormulaTime& time_of(std::span<const FormulaTime> times, std::string_view formula);

/// Those that time_formulas() is to time for the claims here and of outlook_claims.h.
std::vector<std::string> timed_formulas();

std::vector<PaperClaim> speed_claims(const PaperScenes& scenes, const RateTable& rates,
                                     const std::vector<FormulaTime>& times);

}  // namespace lumaknot
