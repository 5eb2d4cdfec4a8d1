/// The claims of sections 5 and 6 about the mesh and speed.
#pragma once

#include <span>
#include <vector>

#include "study/bench/frame_rates.h"
#include "study/bench/report.h"
#include "study/paper/claim.h"
#include "study/paper/formula_times.h"
#include "study/paper/scenes.h"

namespace lumaknot::paper {

PaperClaim grid_claim(long long vertices, long long triangles);

/// Table 2, its rows by paper_rows(), against what the text says about it.
PaperClaim table_claim(std::span<const bench::PaperRow> rows);

PaperClaim slower_claim(std::span<const bench::RateRow> rows);
PaperClaim cost_claim(std::span<const bench::RateRow> rows, std::span<const bench::PaperRow> paper);
PaperClaim real_time_claim(std::span<const bench::RateRow> rows);
PaperClaim glsl_speed_claim(std::span<const bench::RateRow> rows,
                            std::span<const bench::PaperRow> paper,
                            std::span<const bench::MissingRates> missing);

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

/// The formulas that time_formulas() is to time for the claims here and in outlook_claims.h.
std::vector<std::string> timed_formulas();

std::vector<PaperClaim> speed_claims(const PaperScenes& scenes, const bench::RateTable& rates,
                                     const std::vector<FormulaTime>& times);

}  // namespace lumaknot::paper
