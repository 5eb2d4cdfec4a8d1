#include "study/planning/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/error.h"
#include "study/chart_keys.h"
#include "study/nothing_seen.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNotebook = "measured.json";
constexpr double kDroppedShare = 0.25;  // of the tolerance
constexpr double kTruthEnd = 0.2, kSearchEnd = 0.5, kTimesEnd = 0.55;

const KnotSpec& knot_of(const PlanJob& job) {
  if (const auto* knot = std::get_if<KnotSpec>(&job.spec.mesh)) return *knot;
  throw Error(
      "a plan needs mesh.knot: a mesh file has no exact surface to be held to; give the knot that "
      "it was made of");
}

std::string key_of(const PlanJob& job) {
  return fmt::format("{} {} {} {}", scene_key(job.scene, job.spec.mesh), program_key(),
                     job.tolerance.color, job.tolerance.shift);
}

std::vector<Fragment> covered(const Grid<ExactFragment>& fragments) {
  std::vector<Fragment> seen;
  for (const ExactFragment& f : fragments.pixels) {
    if (f.fragment.covered()) seen.push_back(f.fragment);
  }
  return seen;
}

/// The errors as a picture for the eye: white is the tolerance, red beyond it.
Image error_picture(const Grid<float>& errors, double tolerance) {
  Image image(errors.width, errors.height);
  std::ranges::transform(errors.pixels, image.pixels.begin(), [&](float e) {
    const float grey = float(e / tolerance);
    return e <= tolerance ? RgbaPixel{{grey, grey, grey}, 1} : RgbaPixel{{1, 0, 0}, 1};
  });
  return image;
}

/// A plan being made.
class Planning {
 public:
  Planning(const PlanJob& job, const fs::path& folder, const Progress& progress)
      : job_(job), knot_(knot_of(job)), folder_(folder), progress_(progress) {}

  Plan run(const std::function<void(const std::string&)>& told) {
    check_plan(job_);
    const Judge judge(job_.scene, knot_, job_.tolerance, part(0, kTruthEnd));
    Notebook notebook(folder_ / kNotebook, key_of(job_));
    if (notebook.started_anew()) {
      told(fmt::format("{} is of another scene, tolerance or lumaknot: measured anew",
                       (folder_ / kNotebook).string()));
    }
    try {
      plan_with(judge, notebook);
    } catch (const Interrupted&) {
      if (notebook.size() > 0) notebook.save();
      throw;
    }
    notebook.save();
    return std::move(plan_);
  }

 private:
  Progress part(double from, double to) const {
    return [this, from, to](double done) {
      check_interrupted();
      if (progress_) progress_(from + (to - from) * done);
    };
  }

  void plan_with(const Judge& judge, Notebook& notebook) {
    const std::vector<Fragment> seen = covered(judge.fragments());
    if (seen.empty()) throw Error(kNothingSeen);
    plan_.tolerance = job_.tolerance;
    plan_.area = judge.area();
    plan_.share = kDroppedShare * job_.tolerance.color;
    plan_.dropping = drop(job_.scene, seen, plan_.share);
    check_interrupted();
    const Lean& lean = plan_.dropping.lean;
    const Predictor predictor(lean, knot_, seen, job_.tolerance);
    const Choices choices{grid_ladder(knot_, predictor),
                          ways_to_draw(lean.view.material, lean.texture, judge.area(),
                                       shows_fronts_alone(seen, lean.view.camera.position))};
    plan_.considered = int(choices.ladder.size() * choices.ways.size());
    Workshop workshop(lean, knot_, job_.scene, judge, notebook);
    choose(choices, predictor, workshop, notebook);
    prove(choices, predictor, judge, workshop, notebook);
    part(kTimesEnd, 1)(1);
  }

  void choose(const Choices& choices, const Predictor& predictor, Workshop& workshop,
              Notebook& notebook) {
    const std::optional<Method> found =
        fastest_that_meets(choices, predictor, workshop, job_.rounds, part(kTruthEnd, kSearchEnd));
    plan_.met = found.has_value();
    if (job_.exhaustive) {
      const auto best = fastest_of_all(choices, found, workshop, job_.rounds, part(kTimesEnd, 1));
      if (best) {
        plan_.best_of_all = choice_of(*best, predictor, workshop);
        if (found) plan_.time_to_best = workshop.ratio(*found) / workshop.ratio(*best);
      }
    }
    const Method chosen = found ? *found : closest_method(choices, notebook);
    if (!found) workshop.time(std::span(&chosen, 1), job_.rounds);
    workshop.time_reference(job_.rounds);
    plan_.reference_milliseconds = workshop.milliseconds(Workshop::kReference);
    plan_.fast_milliseconds = workshop.milliseconds_beside();
    plan_.chosen = choice_of(chosen, predictor, workshop);
    for (const GridSize& grid : choices.ladder) {
      for (const Method& way : choices.ways) {
        const Method method = with_grid(way, grid);
        if (!notebook.judgements().contains(method_name(method))) continue;
        plan_.choices.push_back(choice_of(method, predictor, workshop));
      }
    }
    if (plan_.best_of_all)
      plan_.best_of_all = choice_of(plan_.best_of_all->method, predictor, workshop);
  }

  static PlanChoice choice_of(const Method& method, const Predictor& predictor,
                              Workshop& workshop) {
    const double time = workshop.milliseconds(method_name(method));
    return {method, predictor.of(method), workshop.judgement(method),
            std::isfinite(time) ? time : 0};
  }

  void prove(const Choices& choices, const Predictor& predictor, const Judge& judge,
             Workshop& workshop, const Notebook&) {
    const Method& method = plan_.chosen.method;
    plan_.parts = error_parts(method, knot_, predictor, workshop);
    if (!plan_.met) plan_.blamed = blame(method, choices, judge, workshop);
    plan_.after = workshop.draw(method);
    PixelErrors errors = judge.judge_all(plan_.after);
    plan_.chosen.judgement = errors.judgement;
    plan_.in_place = error_picture(errors.in_place, job_.tolerance.color);
    plan_.errors = error_picture(errors.errors, job_.tolerance.color);
    plan_.fast = judge.judge(workshop.draw_beside());
    plan_.before = render(job_.scene, [](double) { check_interrupted(); });
    plan_.lean = lean_spec(method);
  }

  /// The smaller scene as scene.json has it.
  SceneSpec lean_spec(const Method& method) const {
    const Lean& lean = plan_.dropping.lean;
    SceneSpec spec{method_mesh(method, knot_), job_.spec.texture, lean.view};
    if (const auto* color = std::get_if<Vec3d>(&lean.texture)) spec.texture = PlainColor{*color};
    spec.view.material = method_material(method, lean.view.material);
    const bool fast = method.number == Number::kFloat;
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
  const ExactTube tube(knot_of(job));
  check_tolerance(job.tolerance, job.scene.view.image.samples > 1);
}

Plan make_plan(const PlanJob& job, const fs::path& folder, const Progress& progress,
               const std::function<void(const std::string&)>& told) {
  return Planning(job, folder, progress).run(told);
}

std::size_t measured_choices(const PlanJob& job, const fs::path& folder) {
  return Notebook(folder / kNotebook, key_of(job)).size();
}

std::vector<std::string> render_arguments(const Method& method) {
  if (method.number == Number::kDouble) return {};
  std::vector<std::string> arguments{"--fast", "--filter",
                                     method.filter == Filter::kTrilinear ? "trilinear" : "bilinear",
                                     "--multisample", std::to_string(method.samples)};
  if (method.culls) arguments.push_back("--cull");
  return arguments;
}

}  // namespace lumaknot
