#include "validate/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <future>
#include <mutex>

namespace lumaknot {
namespace {

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::vector<std::unique_ptr<Renderer>> all_renderers(const Programs& programs) {
  std::vector<std::unique_ptr<Renderer>> all;
  all.push_back(cycles_renderer(programs));
  all.push_back(povray_renderer(programs));
  all.push_back(eevee_renderer(programs));
  return all;
}

/// The stages that name a failure's cause, then the final pictures.
std::vector<Shot> shots_of(const ValidationJob& job) {
  Material terms = job.scene.view.material;
  terms.normal = NormalUse::kUnit;
  std::vector<Shot> shots{{"texture", Stage::kTexture, terms},
                          {"diffuse", Stage::kDiffuse, terms},
                          {"specular", Stage::kSpecular, terms}};
  shots.insert(shots.end(), job.finals.begin(), job.finals.end());
  return shots;
}

/// Our own side of the comparison.
struct Ours {
  Reference reference;
  const std::vector<Shot>& shots;
  const Rendering& rendering;

  const Image& image(Stage stage) const {
    const auto found = std::ranges::find(shots, stage, &Shot::stage);
    return rendering.shots[std::size_t(found - shots.begin())].image;
  }
  Claims claims(const Image& final) const {
    return measure_claims(final, image(Stage::kTexture), image(Stage::kSpecular));
  }
};

Judged judge(const Ours& ours, std::size_t index, Drawn drawn, bool limited, const Limits& limits) {
  Judged result;
  const Shot& shot = drawn.instead ? *drawn.instead : ours.shots[index];
  if (drawn.status == Drawn::Status::kDrawn) {
    result.ours = drawn.instead ? shade_all(ours.reference.scene, shot, ours.reference.fragments)
                                : ours.rendering.shots[index].image;
    result.comparison = compare(ours.reference, shot, result.ours, drawn.image, limited, limits);
    if (shot.stage == Stage::kFinal) result.claims = ours.claims(drawn.image);
  }
  result.drawn = std::move(drawn);
  return result;
}

Judgement judge_all(const Ours& ours, Rendering rendering) {
  Judgement judgement;
  const Limits& limits = limits_of(rendering.renderer);
  for (std::size_t i = 0; i < rendering.shots.size(); ++i) {
    judgement.shots.push_back(
        judge(ours, i, std::move(rendering.shots[i]), rendering.limited, limits));
  }
  rendering.shots.clear();
  judgement.rendering = std::move(rendering);
  return judgement;
}

Verdict verdict_of(const std::vector<Judgement>& judgements) {
  bool compared = false, differs = false;
  for (const Judgement& judgement : judgements) {
    for (const Judged& shot : judgement.shots) {
      compared |= shot.drawn.status == Drawn::Status::kDrawn;
      differs |= shot.drawn.status == Drawn::Status::kFailed || !shot.comparison.agrees();
    }
  }
  if (differs) return Verdict::kDiffered;
  return compared ? Verdict::kAgreed : Verdict::kNothingToCompare;
}

}  // namespace

std::vector<std::string> renderer_names() {
  std::vector<std::string> names;
  for (const auto& renderer : all_renderers({})) names.push_back(lower_case(renderer->name()));
  return names;
}

Scene sample_by_sample(Scene scene) {
  ImageSpec& image = scene.view.image;
  image = {image.width * image.samples, image.height * image.samples, 1};
  return scene;
}

Validation validate(const ValidationJob& job, const std::function<void(const std::string&)>& told) {
  const auto start = std::chrono::steady_clock::now();
  Validation result;
  result.shots = shots_of(job);
  const Scene& scene = job.scene;

  // The others first: they take longest.
  const auto renderers = all_renderers(job.programs);
  std::vector<std::future<Rendering>> drawing;
  std::mutex telling;
  for (const auto& renderer : renderers) {
    const bool wanted = job.renderers.empty() ||
                        std::ranges::count(job.renderers, lower_case(renderer->name())) > 0;
    if (!wanted) continue;
    drawing.push_back(std::async(std::launch::async, [&] {
      Rendering rendering = renderer->draw(scene, result.shots);
      const std::lock_guard lock(telling);
      if (told) told(fmt::format("{}: {:.1f} s", rendering.renderer, rendering.seconds));
      return rendering;
    }));
  }

  const Grid<Fragment> fragments = visible_fragments(scene);
  result.own = own_renderer(fragments)->draw(scene, result.shots);
  const Ours ours{{scene, fragments, silhouettes(scene, fragments)}, result.shots, result.own};
  for (std::size_t i = 0; i < result.shots.size(); ++i) {
    const bool final = result.shots[i].stage == Stage::kFinal;
    result.own_claims.push_back(final ? ours.claims(result.own.shots[i].image) : Claims{});
  }
  for (auto& rendering : drawing) result.judgements.push_back(judge_all(ours, rendering.get()));
  result.verdict = verdict_of(result.judgements);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.seconds = elapsed.count();
  return result;
}

}  // namespace lumaknot
