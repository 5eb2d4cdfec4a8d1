#include "study/paper/speed_claims.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/presets.h"
#include "shaders/graph/shader.h"
#include "study/paper/instruction_slots.h"
#include "study/paper/picture_measures.h"

namespace lumaknot::paper {
namespace {

constexpr std::size_t kSpeedSection = 4;
constexpr std::size_t kTable1 = 2;  // of kRateShots
constexpr double kRealTime = 30;    // frames per second
constexpr double kNoise = 0.5;      // percent by which costs vary between runs

double percent(double share) { return 100 * share; }
double cost_of(const bench::PaperRow& row) { return percent(1 - row.yiq / row.classical); }
double cost_of(const bench::RateRow& row) { return percent(row.costs[kTable1]); }
Interval<double> costs_of(const bench::RateRow& row) {
  const Interval<double>& share = row.cost_intervals[kTable1];
  return {percent(share.min), percent(share.max)};
}
double rate_of(const measure::Spread& milliseconds) { return 1000 / milliseconds.median; }

/// "llvmpipe (LLVM 15.0.6, 256 bits), 1 thread, 4 samples".
std::string row_name(const bench::RateRow& row) {
  return fmt::format("{}, {} thread{}, {} sample{}", row.renderer, row.threads,
                     row.threads == 1 ? "" : "s", row.samples, row.samples == 1 ? "" : "s");
}

/// Whole grids with as many vertices, seams doubled both ways, and triangles.
std::vector<std::pair<long long, long long>> grids(long long vertices, long long triangles) {
  std::vector<std::pair<long long, long long>> found;
  for (long long sides = 1; 2 * sides * sides <= triangles; ++sides) {
    if (triangles % (2 * sides) != 0) continue;
    const long long segments = triangles / (2 * sides);
    if ((segments + 1) * (sides + 1) == vertices) found.emplace_back(segments, sides);
  }
  return found;
}

int slots_of(const Scene& scene, std::string_view formula) {
  const Shot shot{"final", Stage::kFinal, formula_of(scene, formula)};
  return pixel_slots(make_shader({std::string(formula), scene.view, shot, Keep::kNeeded, {}}));
}

Forms forms_of(const PaperScenes& scenes, const std::vector<FormulaTime>& times) {
  const Scene& scene = scenes.front;
  const auto drawn = [&](std::string_view formula) {
    return picture(scenes, scene, formula_of(scene, formula));
  };
  return {slots_of(scene, "rgb-phong"),
          slots_of(scene, "yiq-phong"),
          slots_of(scene, "yiq-collapsed-phong"),
          slots_of(scene, "yiq-baked-phong"),
          times,
          unlimited_change(drawn("yiq-phong"), drawn("yiq-collapsed-phong")).max};
}

Measure time_note(const Forms& forms, std::string_view formula) {
  const measure::Spread& ms = time_of(forms.times, formula).milliseconds;
  return note(fmt::format("{}: a frame ({:.3g} to {:.3g})", formula, ms.min, ms.max), ms.median,
              "ms");
}

/// Compared with the paper's costs if the interval of the rows' minimum or maximum, widened by what
/// runs differ by, is wholly inside or outside them; else a note, and in `claim.beyond` why.
void add_cost(const std::string& what, double cost, const Interval<double>& of_rows,
              const std::pair<double, double>& theirs, PaperClaim& claim) {
  const auto [min, max] = theirs;
  const Interval<double> interval{of_rows.min - kNoise, of_rows.max + kNoise};
  const bool inside = interval.min >= min && interval.max <= max;
  const bool outside = interval.max < min || interval.min > max;
  if (inside || outside) {
    claim.measures.push_back(within(what, cost, min, max, "%"));
    return;
  }
  claim.measures.push_back(note(what, cost, "%"));
  claim.beyond += fmt::format("{}Not decided: the {} is from {:.2g} to {:.2g} %.",
                              claim.beyond.empty() ? "" : " ", what, interval.min, interval.max);
}

}  // namespace

const FormulaTime& time_of(std::span<const FormulaTime> times, std::string_view formula) {
  return *std::ranges::find(times, formula, &FormulaTime::formula);
}

std::vector<std::string> timed_formulas() {
  return {"rgb-phong",        "yiq-phong",    "yiq-collapsed-phong", "yiq-baked-phong",
          "yiq-table1-phong", "yuv601-phong", "cielab-phong",        "cieluv-phong",
          "din99-phong",      "atd95-phong"};
}

PaperClaim grid_claim(long long vertices, long long triangles) {
  constexpr double kVertices = 31529, kTriangles = 61440;
  return {"grid",
          kSpeedSection,
          "The knot of the performance test has 31529 vertices and 61440 triangles.",
          "Counts of the mesh that Figure 2 is drawn of; and how many whole grids of a x b quads "
          "have (a+1)(b+1) vertices and 2ab triangles, all tried.",
          {within("vertices", double(vertices), kVertices, kVertices),
           within("triangles", double(triangles), kTriangles, kTriangles),
           within("grids with those counts", double(grids(31529, 61440).size()), 1, 1)},
          ""};
}

PaperClaim table_claim(std::span<const bench::PaperRow> rows) {
  std::vector<double> costs, longer;
  for (const bench::PaperRow& row : rows) {
    costs.push_back(cost_of(row));
    longer.push_back(percent(row.classical / row.yiq - 1));
  }
  const double max = std::ranges::max(costs);
  return {
      "table2",
      kSpeedSection,
      "In Table 2 YIQ costs around 1 % with 8x multisampling, 5 % without, some 20 % on the "
      "other cards and as high as 32 %; 30 % in the worst case.",
      "From Table 2's own rates, which must round to the text's figures. The text counts frames "
      "a second that are lost; the time of a frame grows by more.",
      {within("GTS 250, 8x", costs[1], 0.5, 1.5, "%"),
       within("GTS 250, none", costs[0], 4.5, 5.5, "%"),
       within("X1950 GT, 6x", costs[3], 15, 25, "%"), within("GMA 950", costs[4], 15, 25, "%"),
       within("most, as high as 32 %", max, 31.5, 32.5, "%"),
       within("most, 30 % in the worst case", max, 25, 35, "%"),
       note("a frame takes longer by at most", std::ranges::max(longer), "%")},
      ""};
}

PaperClaim slower_claim(std::span<const bench::RateRow> rows) {
  const auto count = [&](auto is) {
    return double(
        std::ranges::count_if(rows, [&](const bench::RateRow& r) { return is(costs_of(r)); }));
  };
  const double slower = count([](const Interval<double>& c) { return c.min > kNoise; }),
               faster = count([](const Interval<double>& c) { return c.max < -kNoise; });
  const double decided = slower + faster, open = double(rows.size()) - decided;
  PaperClaim claim{
      "slower",
      kSpeedSection,
      "YIQ-based lighting is slower in all instances than classical lighting.",
      "Rows of this machine's table: frames per second that Table 1's listing loses, from pairs of "
      "neighbouring frames. Slower or faster: by more than half a percent, which is what costs "
      "vary by from run to run, with the 95 % interval of the pairs' median and with each round's. "
      "Where rows are neither, a faster one alone decides.",
      {note("rows not decided", open)},
      ""};
  if (open > 0) {
    claim.beyond = fmt::format(
        "{} of {} rows are too near to their noise to tell; more --rounds and --seconds may.", open,
        rows.size());
  }
  if (open > 0 && faster == 0) {  // "all instances" can be refuted, but not shown
    claim.measures.push_back(note("rows where it is slower", slower));
    return claim;
  }
  claim.measures.insert(claim.measures.begin(),
                        {at_least("rows where it is slower, of those decided", slower, decided),
                         at_most("rows where it is faster", faster, 0)});
  return claim;
}

PaperClaim cost_claim(std::span<const bench::RateRow> rows,
                      std::span<const bench::PaperRow> paper) {
  const auto range = [](const auto& table, const auto& cost) {
    std::vector<double> all;
    for (const auto& row : table) all.push_back(cost(row));
    const auto [min, max] = std::ranges::minmax(all);
    return std::pair(min, max);
  };
  const auto theirs = range(paper, [](const bench::PaperRow& r) { return cost_of(r); });
  const auto ours = range(rows, [](const bench::RateRow& r) { return cost_of(r); });
  const auto low = range(rows, [](const bench::RateRow& r) { return costs_of(r).min; }),
             high = range(rows, [](const bench::RateRow& r) { return costs_of(r).max; });
  PaperClaim claim{"cost",
                   kSpeedSection,
                   "YIQ costs 1 % at best and some 30 % at worst.",
                   "The least and the most of the rows of this machine's table against Table 2's "
                   "least and most, where their 95 % intervals and each round's medians, half a "
                   "percent wider since runs differ by that, decide it.",
                   {},
                   ""};
  add_cost("least cost here", ours.first, {low.first, high.first}, theirs, claim);
  add_cost("most cost here", ours.second, {low.second, high.second}, theirs, claim);
  return claim;
}

PaperClaim real_time_claim(std::span<const bench::RateRow> rows) {
  PaperClaim claim{
      "real-time",
      kSpeedSection,
      "YIQ-based lighting can be used in real time even on a low-end computer.",
      "Frames of Figure 2 a second by Table 1's listing, without any GPU, on "
      "one thread, one sample per pixel. Real time: at least 30; the paper's Atom gave 35 "
      "at 512 x 512.",
      {},
      ""};
  for (const bench::RateRow& row : rows) {
    if (row.threads != 1 || row.samples != 1) continue;
    claim.measures.push_back(
        at_least(row.renderer, rate_of(row.milliseconds[kTable1]), kRealTime, "frames/s"));
  }
  return claim;
}

PaperClaim glsl_speed_claim(std::span<const bench::RateRow> rows,
                            std::span<const bench::PaperRow> paper,
                            std::span<const bench::MissingRates> missing) {
  const double best = cost_of(paper.front());
  PaperClaim claim{"glsl-speed",
                   2,
                   "The code can be converted to GLSL without sacrificing performance.",
                   "The emitted GLSL of the listing against that of classical lighting on Mesa's "
                   "software driver: what it costs may be no more than the paper's HLSL costs its "
                   "newest card without multisampling.",
                   {},
                   ""};
  for (const bench::RateRow& row : rows) {
    if (!row.renderer.starts_with("llvmpipe")) continue;
    claim.measures.push_back(at_most(row_name(row), cost_of(row), best, "%"));
  }
  if (!claim.measures.empty()) return claim;
  claim.measures.push_back(note("paper's cost in HLSL", best, "%"));
  const auto why =
      std::ranges::find(missing, std::string("llvmpipe"), &bench::MissingRates::renderer);
  claim.beyond = why == missing.end() ? "llvmpipe was not asked to draw" : why->why;
  return claim;
}

PaperClaim fast_conversion_claim(const Forms& f) {
  const double conversion = f.matrices_slots - f.rgb_slots;
  constexpr double kSmall = 20, kQuick = 5;
  return {
      "fast-conversion",
      1,
      "The conversion between RGB and YIQ is a simple linear transformation that shaders do very "
      "quickly.",
      "Instruction slots that eq. 6-8 by both matrices take beyond eq. 3, and the frame rate "
      "that they cost on one thread. Very quickly: a fifth of the slots and 5 % at most.",
      {at_most("slots of both conversions, of the pixel shader's",
               percent(conversion / f.matrices_slots), kSmall, "%"),
       at_most("frame rate lost", percent(time_of(f.times, "yiq-phong").cost), kQuick, "%"),
       note("slots of both conversions", conversion)},
      ""};
}

PaperClaim half_claim(const Forms& f) {
  const double conversion = f.matrices_slots - f.rgb_slots;
  return {"half",
          kSpeedSection,
          "A texture specified in YIQ reduces the number of conversions by half.",
          "Instruction slots of the pixel shader: what of those that eq. 6-8 take beyond eq. 3 a "
          "texture that holds Y, I, Q saves. Half: 40 to 60 %.",
          {within("saved of the conversions",
                  percent((f.matrices_slots - f.baked_slots) / conversion), 40, 60, "%"),
           note("slots, classical", f.rgb_slots), note("slots, eq. 6-8", f.matrices_slots),
           note("slots, texture in YIQ", f.baked_slots)},
          ""};
}

PaperClaim most_efficient_claim(const Forms& f) {
  const FormulaTime &baked = time_of(f.times, "yiq-baked-phong"),
                    &collapsed = time_of(f.times, "yiq-collapsed-phong"),
                    &matrices = time_of(f.times, "yiq-phong");
  const double other = std::min(collapsed.milliseconds.median, matrices.milliseconds.median);
  constexpr double kSame = 1.02;
  return {
      "most-efficient",
      1,
      "The most efficient way would be to have the texture's pixels specified in YIQ.",
      "Slots and times of one frame on one thread, against the other forms of eq. 6-8; times "
      "within 2 % are equal. The collapsed form, F = T + (Y_F - Y_T), needs no conversion back.",
      {at_most("slots, texture in YIQ", f.baked_slots,
               std::min(f.collapsed_slots, f.matrices_slots)),
       at_most("its time over the best other form's", baked.milliseconds.median / other, kSame),
       time_note(f, "yiq-baked-phong"), time_note(f, "yiq-collapsed-phong"),
       time_note(f, "yiq-phong")},
      ""};
}

PaperClaim collapsed_claim(const Forms& f) {
  const double faster = percent(1 - time_of(f.times, "yiq-collapsed-phong").milliseconds.median /
                                        time_of(f.times, "yiq-phong").milliseconds.median);
  constexpr double kFloat = 1e-6;  // colours kept as float
  return {"optimised",
          kSpeedSection,
          "As I and Q do not change, the conversion can be optimised to take fewer operations.",
          "The collapsed form against eq. 6-8 by matrices: slots; the largest difference of the "
          "front picture, unlimited; and how much less time a frame takes on one thread.",
          {at_most("slots, collapsed", f.collapsed_slots, f.matrices_slots - 1),
           note("slots, matrices", f.matrices_slots),
           at_most("largest difference of the pictures", f.collapsed_differs, kFloat),
           note("less time a frame", faster, "%")},
          ""};
}

PaperClaim no_compromise_claim(const Forms& f) {
  const auto cost = [&](std::string_view formula) {
    return percent(time_of(f.times, formula).cost);
  };
  constexpr double kAround = 1;
  return {
      "no-compromise",
      kSpeedSection,
      "A texture in YIQ gives the benefits without compromising the performance.",
      "Frame rate lost beside classical lighting, one thread, from pairs of neighbouring frames. "
      "No compromise: no more than the 1 % that the paper calls the best case.",
      {at_most("texture in YIQ", cost("yiq-baked-phong"), kAround, "%"),
       note("eq. 6-8 by matrices", cost("yiq-phong"), "%"),
       note("collapsed", cost("yiq-collapsed-phong"), "%"),
       note("Table 1's listing", cost("yiq-table1-phong"), "%")},
      ""};
}

PaperClaim rgb_output_claim(const Forms& f) {
  return {
      "rgb-output",
      kSpeedSection,
      "A limitation is that the pixel shader's colour still has to be RGB, which future APIs may "
      "alleviate.",
      "Instruction slots that eq. 6-8 with a texture in YIQ take beyond eq. 3: the way back to "
      "RGB, which such an output would save.",
      {note("slots of the conversion back", f.baked_slots - f.rgb_slots),
       note("slots of the pixel shader", f.baked_slots)},
      "None of the renderers here has an output in YIQ."};
}

std::vector<PaperClaim> speed_claims(const PaperScenes& scenes, const bench::RateTable& rates,
                                     const std::vector<FormulaTime>& times) {
  const Forms forms = forms_of(scenes, times);
  const TriangleMesh& mesh = scenes.front.mesh;
  return {fast_conversion_claim(forms),
          most_efficient_claim(forms),
          glsl_speed_claim(rates.rows, bench::paper_rows(), rates.missing),
          grid_claim((long long)mesh.positions.size(), (long long)mesh.triangles.size()),
          table_claim(bench::paper_rows()),
          slower_claim(rates.rows),
          cost_claim(rates.rows, bench::paper_rows()),
          real_time_claim(rates.rows),
          half_claim(forms),
          collapsed_claim(forms),
          no_compromise_claim(forms),
          rgb_output_claim(forms)};
}

}  // namespace lumaknot::paper
