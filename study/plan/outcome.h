/// The cheapest model of a scene that meets a tolerance.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/plan/attribution.h"
#include "study/plan/pruning.h"
#include "study/plan/search.h"

namespace lumaknot::plan {

struct PlanJob {
  Scene scene;  ///< with its own mesh
  SceneSpec spec;
  Tolerance tolerance;
  bool exhaustive = false;  ///< measures every choice, to report how close to the best the plan is
  int rounds = 5;           ///< per method; contenders get three times as many
};

/// One choice as measured.
struct PlanChoice {
  measure::Method method;
  PredictedError predicted;
  ToleranceResult result;
  double milliseconds = 0;  ///< 0: not timed
};

/// The choice, and the proof.
struct Plan {
  Tolerance tolerance;
  bool area = false;
  Pruning pruning;
  double share = 0;  ///< of the tolerance, for what is dropped
  bool met = false;
  PlanChoice chosen;                   ///< the closest if nothing meets the tolerance
  std::vector<ErrorPart> parts;        ///< of the chosen method
  std::vector<Attribution> blamed;     ///< if it is not met
  std::vector<PlanChoice> candidates;  ///< all that was measured
  int considered = 0;                  ///< the number of choices
  SceneSpec simplified;                ///< the smaller scene, to be drawn with render_arguments()
  double reference_milliseconds = 0, fast_milliseconds = 0;  ///< before, one thread
  ToleranceResult reference, fast;  ///< of the scene as the reference and as --fast draw it, before
  /// Pixels within the tolerance in place in the reference's picture and not in the plan's, and the
  /// other way about.
  long long lost_in_place = 0, won_in_place = 0;
  std::optional<PlanChoice> best_of_all;  ///< of the exhaustive search
  double time_to_best = 0;  ///< the chosen time over that of best_of_all, the same rounds
  Image before, after;      ///< the reference, the plan's picture
  Image in_place, errors;   ///< the errors of `after`, in place and after the shift
};

/// Throws Error for a tolerance that no picture can be checked against, a mesh file, and a knot
/// without an exact surface. Draws nothing.
void check_plan(const PlanJob& job);

/// Plans; what is measured is kept in `folder`/measured.json. `on_message` gets a line if that
/// holds measurements of another scene, program or tolerance. Throws Interrupted, after which the
/// same call resumes, and Error as check_plan() and for a scene that covers no pixel.
Plan make_plan(const PlanJob& job, const std::filesystem::path& folder, const Progress& progress,
               const std::function<void(const std::string&)>& on_message);

/// The number of choices of this job in `folder`/measured.json.
std::size_t measured_choices(const PlanJob& job, const std::filesystem::path& folder);

/// The arguments of `lumaknot render SCENE -o PICTURE` that draw the plan's scene as planned.
std::vector<std::string> render_arguments(const measure::Method& method);

/// The certificate: tolerance, what was dropped, every choice predicted and measured, times.
std::string plan_json(const Plan& plan);

/// The same, short, for a terminal.
std::string plan_text(const Plan& plan);

/// One HTML page that needs nothing else. `command` draws the planned picture.
std::string plan_html(const Plan& plan, const std::string& scene, const std::string& command);

}  // namespace lumaknot::plan
