/// The cheapest model of a scene that meets a tolerance.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/planning/dropping.h"
#include "study/planning/parts.h"
#include "study/planning/search.h"

namespace lumaknot {

struct PlanJob {
  Scene scene;  ///< with its own mesh
  SceneSpec spec;
  Tolerance tolerance;
  bool exhaustive = false;  ///< measures every choice, to tell how near to the best the plan is
  int rounds = 5;           ///< that time a method; contenders get three times as many
};

/// One choice as measured.
struct PlanChoice {
  Method method;
  PredictedError predicted;
  ToleranceResult judgement;
  double milliseconds = 0;  ///< 0: not timed
};

/// What was chosen, and the proof.
struct Plan {
  Tolerance tolerance;
  bool area = false;
  Dropping dropping;
  double share = 0;  ///< of the tolerance, for what is dropped
  bool met = false;
  PlanChoice chosen;                ///< where nothing meets the tolerance, the closest
  std::vector<ErrorPart> parts;     ///< of what was chosen
  std::vector<Blame> blamed;        ///< where it is not met
  std::vector<PlanChoice> choices;  ///< all that was measured
  int considered = 0;               ///< choices that there are
  SceneSpec lean;                   ///< the smaller scene, to be drawn as render_arguments() tell
  double reference_milliseconds = 0, fast_milliseconds = 0;  ///< before, one thread
  ToleranceResult fast;                   ///< of the scene as --fast draws it, before
  std::optional<PlanChoice> best_of_all;  ///< of the exhaustive search
  double time_to_best = 0;  ///< the chosen time over that of best_of_all, the same rounds
  Image before, after;      ///< the reference, the plan's picture
  Image in_place, errors;   ///< the errors of that, in place and after the shift

  /// Pixels that meet the tolerance by the shift alone: the count, and of those judged.
  long long shifted() const { return chosen.judgement.shifted - chosen.judgement.failing; }
  double shifted_share() const {
    return double(shifted()) / double(std::max(1LL, chosen.judgement.covered));
  }
};

/// Throws Error for a tolerance that no picture can be held to, a mesh file, and a knot without an
/// exact surface. Draws nothing.
void check_plan(const PlanJob& job);

/// Plans; what is measured is kept in `folder`/measured.json. `told` gets a line when what that
/// holds is of another scene, program or tolerance. Throws Interrupted, after which the same call
/// goes on, and Error as check_plan() and for a scene that covers no pixel.
Plan make_plan(const PlanJob& job, const std::filesystem::path& folder, const Progress& progress,
               const std::function<void(const std::string&)>& told);

/// How many choices of this job `folder`/measured.json holds.
std::size_t measured_choices(const PlanJob& job, const std::filesystem::path& folder);

/// The arguments of `lumaknot render SCENE -o PICTURE` that draw the plan's scene as planned.
std::vector<std::string> render_arguments(const Method& method);

/// What to know of a tolerance that many pixels meet by the shift alone; empty for few.
std::string shift_warning(const Plan& plan);

/// "1.26 times faster than", or slower.
std::string pace_than(double before, double after);

/// The certificate: tolerance, what was dropped, every choice predicted and measured, times.
std::string plan_json(const Plan& plan);

/// The same, short, for a terminal.
std::string plan_text(const Plan& plan);

/// One HTML page that needs nothing else. `command` draws the planned picture.
std::string plan_html(const Plan& plan, const std::string& scene, const std::string& command);

}  // namespace lumaknot
