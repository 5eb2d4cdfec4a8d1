#include "validate/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <mutex>

#include "exporters/image/file.h"
#include "system/error.h"
#include "validate/renderers/entry.h"

namespace lumaknot::validate {
namespace {

/// Our own side of the comparison.
struct Ours {
  Reference reference;
  const std::vector<Shot>& shots;
  const Rendering& rendering;
  std::size_t budget;                            ///< bytes of a renderer's picture in the report
  bool keeps_displays;                           ///< see ValidationJob
  std::vector<Grid<Sensitivity>> sensitivities;  ///< of `shots`

  const Image& image(Stage stage) const {
    const auto found = std::ranges::find(shots, stage, &Shot::stage);
    return rendering.shots[std::size_t(found - shots.begin())].image;
  }
  Claims claims(const Image& final) const {
    return measure_claims(final, image(Stage::kTexture), image(Stage::kSpecular));
  }
};

Judged judge(const Ours& ours, std::size_t index, RenderedShot drawn, Standard standard) {
  Judged result;
  if (drawn.status == RenderedShot::Status::kDrawn) {
    const Shot& shot = drawn.instead ? *drawn.instead : ours.shots[index];
    Image nearest;
    Grid<Sensitivity> nearest_sensitivities;
    if (drawn.instead) {
      nearest = shade_all(ours.reference.scene, shot, ours.reference.fragments);
      nearest_sensitivities = sensitivities(ours.reference, shot);
    }
    const Image& mine = drawn.instead ? nearest : ours.rendering.shots[index].image;
    standard.output_steps = drawn.output_steps;
    result.comparison =
        compare(ours.reference, shot, mine, drawn.image,
                drawn.instead ? nearest_sensitivities : ours.sensitivities[index], standard);
    if (shot.stage == Stage::kFinal) result.claims = ours.claims(drawn.image);
    result.pictures =
        pictures_of({mine, drawn.image, standard.limited}, result.comparison.marks, ours.budget);
    if (drawn.instead) {
      const Image& requested = ours.rendering.shots[index].image;
      result.pictures.instead = instead_picture(requested, nearest, ours.budget);
    }
    if (ours.keeps_displays) result.pictures.display = display_png(drawn.image);
    result.comparison.marks = {};
  }
  result.drawn = std::move(drawn);
  return result;
}

/// Coverage is the first rung; the others follow in the shots' order.
std::string first_difference(const std::vector<Shot>& shots, const RendererResult& result) {
  if (result.coverage_unexplained > 0) return "coverage";
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const Judged& judged = result.shots[i];
    if (judged.drawn.status == RenderedShot::Status::kDrawn &&
        judged.comparison.outcome() == Outcome::kDiffered) {
      return shots[i].name;
    }
  }
  return {};
}

/// The classes of all rungs that are beyond what is allowed, the largest share of each.
std::vector<ClassShare> explained_classes(const RendererResult& result) {
  std::vector<ClassShare> worst;
  const auto add = [&](const ClassShare& share) {
    if (!share.exceeded) return;
    const auto same = std::ranges::find(worst, share.allowance, &ClassShare::allowance);
    if (same == worst.end()) {
      worst.push_back(share);
    } else if (share.share() > same->share()) {
      *same = share;
    }
  };
  add(result.coverage_share);
  for (const Judged& judged : result.shots) {
    for (const ClassShare& share : judged.comparison.shares) add(share);
  }
  return exceeded_shares(std::move(worst));
}

/// Coverage is judged once, by the shot in which it differs most.
void judge_coverage(const Ours& ours, const Allowances& allowances, RendererResult& result) {
  long long covered = 0, explained = 0;
  for (const Judged& judged : result.shots) {
    const Comparison& c = judged.comparison;
    covered = std::max(covered, c.covered);
    explained = std::max(explained, c.coverage_differs - c.coverage_unexplained);
    result.coverage_differs = std::max(result.coverage_differs, c.coverage_differs);
    result.coverage_unexplained = std::max(result.coverage_unexplained, c.coverage_unexplained);
    if (c.has_no_coverage) result.coverage_note = "the alpha of its images is 0 everywhere";
  }
  result.coverage_share = class_share(kCoverageAllowance, explained, covered,
                                      ours.reference.silhouette_length, allowances);
}

/// The shot whose picture tells most about a difference: a final one that differs, as it shows all
/// that may cause it, or else the first rung.
std::size_t telling_shot(const std::vector<Shot>& shots, const RendererResult& result) {
  const bool by_coverage = result.first_difference == "coverage";
  std::size_t first = shots.size();
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const Judged& judged = result.shots[i];
    if (judged.drawn.status != RenderedShot::Status::kDrawn) continue;
    if (!by_coverage && judged.comparison.outcome() != Outcome::kDiffered) continue;
    if (shots[i].stage == Stage::kFinal) return i;
    first = std::min(first, i);
  }
  return first;
}

/// Nothing if the renderer drew no texture without light, so that its pictures don't tell.
std::optional<FirstDifference> first_by_pictures(const std::vector<Shot>& shots,
                                                 const RendererResult& result) {
  if (result.first_difference == "coverage") return FirstDifference::kCoverage;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const Judged& judged = result.shots[i];
    if (shots[i].stage != Stage::kTexture) continue;
    if (judged.drawn.status != RenderedShot::Status::kDrawn) return {};
    return judged.comparison.outcome() == Outcome::kDiffered ? FirstDifference::kTexture
                                                             : FirstDifference::kLight;
  }
  return {};
}

/// The cause of a difference, from the picture that tells most; it may be of a rung that no
/// picture shows alone.
void name_cause(const Ours& ours, const std::optional<KnotSpec>& knot, RendererResult& result) {
  if (result.first_difference.empty()) return;
  const std::size_t index = telling_shot(ours.shots, result);
  if (index == ours.shots.size()) return;
  const RenderedShot& drawn = result.shots[index].drawn;
  const Shot& shot = drawn.instead ? *drawn.instead : ours.shots[index];
  Cause cause = find_cause(ours.reference.scene, knot, shot, drawn.image, result.rendering.limited);
  if (const std::optional<FirstDifference> first = first_by_pictures(ours.shots, result)) {
    prefer_by_rung(cause.diagnosis, *first);
    const std::string rung = rung_of(cause.diagnosis, *first);
    if (!rung.empty()) result.first_difference = rung;
  }
  result.cause = cause_sentence(result.rendering.renderer, cause);
  result.found_cause = std::move(cause);
}

RendererResult judge_all(const Ours& ours, Rendering rendering, const ValidationJob& job) {
  RendererResult result;
  const RendererEntry& entry = renderer_entry(rendering.renderer);
  result.promise = promise_of(entry, rendering.version);
  const auto stated = job.limits.find(entry.flag);
  if (stated != job.limits.end()) result.limits = stated->second;
  const Standard standard{rendering.limited, 1, result.promise, result.limits, job.allowances};
  for (std::size_t i = 0; i < rendering.shots.size(); ++i) {
    result.shots.push_back(judge(ours, i, std::move(rendering.shots[i]), standard));
  }
  rendering.shots.clear();
  result.rendering = std::move(rendering);
  judge_coverage(ours, job.allowances, result);
  result.first_difference = first_difference(ours.shots, result);
  result.explained = explained_classes(result);
  name_cause(ours, job.knot, result);
  for (Judged& judged : result.shots) judged.drawn.image = {};
  return result;
}

Verdict verdict_of(const std::vector<RendererResult>& results) {
  const auto any = [&](auto holds) { return std::ranges::any_of(results, holds); };
  const auto is = [](Outcome outcome) {
    return [outcome](const RendererResult& r) { return r.outcome() == outcome; };
  };
  if (any(is(Outcome::kDiffered))) return Verdict::kDiffered;
  if (any(is(Outcome::kExplained))) return Verdict::kExplained;
  return any([](const RendererResult& r) { return r.drew_any(); }) ? Verdict::kAgreed
                                                                   : Verdict::kNothingToCompare;
}

/// The renderers that the job asks for.
std::vector<std::unique_ptr<Renderer>> wanted_renderers(const ValidationJob& job) {
  std::vector<std::unique_ptr<Renderer>> wanted;
  for (const RendererEntry* entry : renderer_entries()) {
    const bool asked = std::ranges::count(job.renderers, entry->flag) > 0;
    if (job.renderers.empty() ? entry->by_default : asked) {
      wanted.push_back(entry->make(job.programs));
    }
  }
  return wanted;
}

Ours draw_ours(const ValidationJob& job, const Grid<Fragment>& fragments, std::size_t renderers,
               Validation& result) {
  result.own = own_renderer(fragments)->draw(job.scene, result.shots);
  Ours ours{Reference(job.scene, fragments),
            result.shots,
            result.own,
            picture_budget(renderers * result.shots.size()),
            job.keeps_displays,
            {}};
  for (const Shot& shot : result.shots) {
    ours.sensitivities.push_back(sensitivities(ours.reference, shot));
  }
  return ours;
}

}  // namespace

bool RendererResult::drew_any() const {
  return std::ranges::any_of(
      shots, [](const Judged& shot) { return shot.drawn.status == RenderedShot::Status::kDrawn; });
}

Outcome RendererResult::coverage_outcome() const {
  if (coverage_unexplained > 0) return Outcome::kDiffered;
  return coverage_share.exceeded ? Outcome::kExplained : Outcome::kAgreed;
}

Outcome RendererResult::outcome() const {
  const bool failed = std::ranges::any_of(
      shots, [](const Judged& shot) { return shot.drawn.status == RenderedShot::Status::kFailed; });
  if (failed || !first_difference.empty()) return Outcome::kDiffered;
  return explained.empty() ? Outcome::kAgreed : Outcome::kExplained;
}

std::vector<Shot> shots_of(const ValidationJob& job) {
  Material terms = job.finals.empty() ? job.scene.view.material : job.finals.front().material;
  terms.normal = NormalUse::kUnit;
  std::vector<Shot> shots{{"texture", Stage::kTexture, terms},
                          {"diffuse", Stage::kDiffuse, terms},
                          {"specular", Stage::kSpecular, terms}};
  shots.insert(shots.end(), job.finals.begin(), job.finals.end());
  return shots;
}

void conclude(Validation& v) {
  for (RendererResult& r : v.results) r.first_difference = first_difference(v.shots, r);
  v.verdict = verdict_of(v.results);
}

Scene sample_by_sample(Scene scene) {
  ImageSpec& image = scene.view.image;
  image = {image.width * image.samples, image.height * image.samples, 1};
  return scene;
}

Validation validate(const ValidationJob& job,
                    const std::function<void(const std::string&)>& on_message) {
  const auto start = std::chrono::steady_clock::now();
  Validation result;
  result.shots = shots_of(job);
  const Scene& scene = job.scene;
  const Grid<Fragment> fragments = visible_fragments(scene);
  if (std::ranges::none_of(fragments.pixels, &Fragment::covered)) {
    throw Error("the camera sees nothing of the mesh; move camera.position or camera.target");
  }

  // The other programs first: they take longest, and ours finishes before they do.
  const auto renderers = wanted_renderers(job);
  std::promise<const Ours*> promise;
  const std::shared_future<const Ours*> ours_drawn = promise.get_future().share();
  std::mutex telling;
  std::vector<std::future<RendererResult>> tasks;
  tasks.reserve(renderers.size());
  for (const auto& renderer : renderers) {
    tasks.push_back(std::async(std::launch::async, [&, ours_drawn] {
      Rendering rendering = renderer->draw(scene, result.shots);
      RendererResult judged = judge_all(*ours_drawn.get(), std::move(rendering), job);
      const std::lock_guard lock(telling);
      if (on_message)
        on_message(fmt::format("{}: {:.1f} s", renderer->name(), judged.rendering.seconds));
      return judged;
    }));
  }

  const Ours ours = draw_ours(job, fragments, renderers.size(), result);
  promise.set_value(&ours);
  for (std::size_t i = 0; i < result.shots.size(); ++i) {
    const bool final = result.shots[i].stage == Stage::kFinal;
    const Image& image = result.own.shots[i].image;
    result.own_claims.push_back(final ? ours.claims(image) : Claims{});
    result.own_pictures.push_back(own_picture(image, ours.budget));
  }
  result.own_cover = cover_png(ours.reference);
  for (auto& task : tasks) result.results.push_back(task.get());
  result.verdict = verdict_of(result.results);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.seconds = elapsed.count();
  return result;
}

}  // namespace lumaknot::validate
