#include "study/plan/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/measure/empty_scene.h"
#include "study/measure/fingerprint.h"
#include "system/error.h"
#include "system/process.h"

namespace lumaknot::plan {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStoreFile = "measured.json";
constexpr double kDroppedShare = 0.25;  // of the tolerance
constexpr double kTruthEnd = 0.2, kSearchEnd = 0.5, kTimingEnd = 0.55;

const KnotSpec& knot_of(const PlanJob& job) {
  if (const auto* knot = std::get_if<KnotSpec>(&job.spec.mesh)) return *knot;
  throw Error(
      "a plan needs mesh.knot: a mesh file has no exact surface to compare with; give the knot "
      "that "
      "it was built from");
}

std::string key_of(const PlanJob& job) {
  const Tolerance& t = job.tolerance;
  return fmt::format("{} {} {} {} {}", measure::scene_key(job.scene, job.spec.mesh),
                     measure::program_key(), t.color, t.shift, t.in_place);
}

std::vector<Fragment> covered(const Grid<exact::ExactFragment>& fragments) {
  std::vector<Fragment> seen;
  for (const exact::ExactFragment& f : fragments.pixels) {
    if (f.fragment.covered()) seen.push_back(f.fragment);
  }
  return seen;
}

/// The errors as a picture: white is the tolerance, red beyond it.
Image error_picture(const Grid<float>& errors, double tolerance) {
  Image image(errors.width, errors.height);
  std::ranges::transform(errors.pixels, image.pixels.begin(), [&](float e) {
    const float grey = float(e / tolerance);
    return e <= tolerance ? RgbaPixel{{grey, grey, grey}, 1} : RgbaPixel{{1, 0, 0}, 1};
  });
  return image;
}

/// Makes a plan.
class Planning {
 public:
  Planning(const PlanJob& job, const fs::path& folder, const Progress& progress)
      : job_(job), knot_(knot_of(job)), folder_(folder), progress_(progress) {}

  Plan run(const std::function<void(const std::string&)>& on_message) {
    check_plan(job_);
    const ToleranceChecker checker(job_.scene, knot_, job_.tolerance, part(0, kTruthEnd));
    MeasurementStore store(folder_ / kStoreFile, key_of(job_));
    if (store.started_again()) {
      on_message(fmt::format("{} is of another scene, tolerance or lumaknot: measured again",
                             (folder_ / kStoreFile).string()));
    }
    try {
      plan_with(checker, store);
    } catch (const Interrupted&) {
      if (store.size() > 0) store.save();
      throw;
    }
    store.save();
    return std::move(plan_);
  }

 private:
  Progress part(double from, double to) const {
    return [this, from, to](double done) {
      check_interrupted();
      if (progress_) progress_(from + (to - from) * done);
    };
  }

  void plan_with(const ToleranceChecker& checker, MeasurementStore& store) {
    const std::vector<Fragment> seen = covered(checker.fragments());
    if (seen.empty()) throw Error(measure::kNothingSeen);
    plan_.tolerance = job_.tolerance;
    plan_.area = checker.area();
    plan_.share = kDroppedShare * job_.tolerance.color;
    plan_.pruning = drop(job_.scene, seen, plan_.share);
    check_interrupted();
    const SimplifiedScene& simplified = plan_.pruning.simplified;
    const Predictor predictor(simplified, knot_, seen, job_.tolerance);
    const Candidates candidates{
        grid_ladder(knot_, predictor),
        methods_to_draw(simplified.view.material, simplified.texture, checker.area(),
                        shows_fronts_alone(seen, simplified.view.camera.position))};
    plan_.considered = int(candidates.ladder.size() * candidates.methods.size());
    measure::MethodBench bench({job_.scene.mesh, simplified.texture, simplified.view}, knot_,
                               [this] { return fast_frame(job_.scene); });
    Trials trials(bench, checker, store);
    choose(candidates, predictor, trials, store);
    prove(candidates, predictor, checker, bench);
    part(kTimingEnd, 1)(1);
  }

  void choose(const Candidates& candidates, const Predictor& predictor, Trials& trials,
              const MeasurementStore& store) {
    const std::optional<measure::Method> found =
        fastest_that_meets(candidates, predictor, trials, job_.rounds, part(kTruthEnd, kSearchEnd));
    plan_.met = found.has_value();
    if (job_.exhaustive) {
      const auto best = fastest_of_all(candidates, found, trials, job_.rounds, part(kTimingEnd, 1));
      if (best) {
        plan_.best_of_all = choice_of(*best, predictor, trials);
        if (found) plan_.time_to_best = trials.ratio(*found) / trials.ratio(*best);
      }
    }
    const measure::Method chosen = found ? *found : closest_method(candidates, store);
    if (!found) trials.time(std::span(&chosen, 1), job_.rounds);
    trials.time_reference(job_.scene, job_.rounds);
    plan_.reference_milliseconds = trials.milliseconds(Trials::kReference);
    plan_.fast_milliseconds = trials.baseline_milliseconds();
    plan_.chosen = choice_of(chosen, predictor, trials);
    for (const measure::GridSize& grid : candidates.ladder) {
      for (const measure::Method& without_grid : candidates.methods) {
        const measure::Method method = measure::with_grid(without_grid, grid);
        if (!store.results().contains(measure::method_name(method))) continue;
        plan_.candidates.push_back(choice_of(method, predictor, trials));
      }
    }
    if (plan_.best_of_all)
      plan_.best_of_all = choice_of(plan_.best_of_all->method, predictor, trials);
  }

  static PlanChoice choice_of(const measure::Method& method, const Predictor& predictor,
                              Trials& trials) {
    const double time = trials.milliseconds(measure::method_name(method));
    return {method, predictor.of(method), trials.result(method), std::isfinite(time) ? time : 0};
  }

  void prove(const Candidates& candidates, const Predictor& predictor,
             const ToleranceChecker& checker, measure::MethodBench& bench) {
    const measure::Method& method = plan_.chosen.method;
    plan_.parts = error_parts(method, knot_, predictor, bench);
    if (!plan_.met) plan_.blamed = attribute(method, candidates, checker, bench);
    plan_.after = bench.draw(method);
    PixelErrors errors = checker.check_all(plan_.after);
    plan_.chosen.result = errors.total;
    plan_.in_place = error_picture(errors.in_place, job_.tolerance.color);
    plan_.errors = error_picture(errors.errors, job_.tolerance.color);
    plan_.fast = checker.check_all(fast_image(job_.scene)).total;
    plan_.before = render(job_.scene, [](double) { check_interrupted(); });
    compare_in_place(checker.check_all(plan_.before), errors);
    plan_.simplified = lean_spec(method);
  }

  void compare_in_place(const PixelErrors& before, const PixelErrors& after) {
    plan_.reference = before.total;
    for (std::size_t i = 0; i < after.in_place.pixels.size(); ++i) {
      const bool met_before = before.in_place.pixels[i] <= job_.tolerance.color;
      const bool met_after = after.in_place.pixels[i] <= job_.tolerance.color;
      plan_.lost_in_place += met_before && !met_after;
      plan_.won_in_place += met_after && !met_before;
    }
  }

  /// The smaller scene as written to scene.json.
  SceneSpec lean_spec(const measure::Method& method) const {
    const SimplifiedScene& simplified = plan_.pruning.simplified;
    SceneSpec spec{measure::method_mesh(method, knot_), job_.spec.texture, simplified.view};
    if (const auto* color = std::get_if<Vec3d>(&simplified.texture))
      spec.texture = PlainColor{*color};
    spec.view.material = measure::method_material(method, simplified.view.material);
    const bool fast = method.number == measure::Number::kFloat;
    spec.view.image.samples = fast ? 1 : int(std::lround(std::sqrt(method.samples)));
    return spec;
  }

  const PlanJob& job_;
  KnotSpec knot_;
  fs::path folder_;
  const Progress& progress_;
  Plan plan_;
};

}  // namespace

void check_plan(const PlanJob& job) {
  const exact::ExactTube tube(knot_of(job));
  check_tolerance(job.tolerance, job.scene.view.image.samples > 1);
}

Plan make_plan(const PlanJob& job, const fs::path& folder, const Progress& progress,
               const std::function<void(const std::string&)>& on_message) {
  return Planning(job, folder, progress).run(on_message);
}

std::size_t measured_choices(const PlanJob& job, const fs::path& folder) {
  return MeasurementStore(folder / kStoreFile, key_of(job)).size();
}

std::vector<std::string> render_arguments(const measure::Method& method) {
  if (method.number == measure::Number::kDouble) return {};
  std::vector<std::string> arguments{"--fast", "--filter",
                                     method.filter == Filter::kTrilinear ? "trilinear" : "bilinear",
                                     "--multisample", std::to_string(method.samples)};
  if (method.culls) arguments.push_back("--cull");
  return arguments;
}

}  // namespace lumaknot::plan
