#include "bench/verdicts/agreeing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/verdicts/random_scene.h"
#include "diagnosis/diagnose.h"
#include "validate/compare/images.h"
#include "validate/compare/sensitivity.h"
#include "validate/renderers/entry.h"

namespace lumaknot::verdicts {
namespace {

using validate::Outcome;
using validate::RenderedShot;

/// Values rounded to `steps` steps, as a file of integers keeps them; 0: as they are.
Image stored(Image image, double steps) {
  if (steps == 0) return image;
  for (RgbaPixel& p : image.pixels) {
    for (float* v : {&p.color.r, &p.color.g, &p.color.b}) {
      *v = float(std::round(std::clamp(double(*v), 0.0, 1.0) * steps) / steps);
    }
  }
  return image;
}

/// One scene, drawn by us.
class Judge {
 public:
  Judge(const RandomScene& random, std::uint64_t seed)
      : random_(random),
        seed_(seed),
        fragments_(visible_fragments(random.scene)),
        reference_(random.scene, fragments_) {
    Material terms = random.scene.view.material;
    terms.normal = NormalUse::kUnit;
    shots_ = {{"texture", Stage::kTexture, terms},
              {"diffuse", Stage::kDiffuse, terms},
              {"specular", Stage::kSpecular, terms},
              {"final", Stage::kFinal, random.scene.view.material}};
  }

  bool sees_anything() const { return std::ranges::any_of(fragments_.pixels, &Fragment::covered); }

  void count(const std::string& flag, AgreeingCounts& counts) const {
    const validate::RendererEntry& entry =
        **std::ranges::find(validate::renderer_entries(), flag, &validate::RendererEntry::flag);
    const validate::Rendering rendering = entry.make({})->draw(random_.scene, shots_);
    validate::Standard standard;
    standard.limited = rendering.limited;
    standard.promise = promise_of(entry, rendering.version);
    Outcome worst = Outcome::kAgreed;
    validate::Comparison last;
    for (std::size_t i = 0; i < shots_.size(); ++i) {
      const RenderedShot& drawn = rendering.shots[i];
      if (drawn.status == RenderedShot::Status::kFailed) {
        tell(flag, fmt::format("{} failed: {}", shots_[i].name, drawn.why));
        ++counts.failed;
        return;
      }
      if (drawn.status == RenderedShot::Status::kSkipped || drawn.instead) {
        ++counts.skipped;
        return;
      }
      last = compared(shots_[i], drawn, standard);
      tell_of(flag, shots_[i].name, last);
      worst = std::max(worst, outcome_of(last));
    }
    ++counts.scenes;
    counts.differed += worst == Outcome::kDiffered;
    counts.explained += worst == Outcome::kExplained;
    for (const double steps : {0.0, 65535.0, 255.0}) {
      const Image& picture = rendering.shots.back().image;
      const auto cause = named_cause(stored(picture, steps), rendering.limited || steps > 0);
      ++counts.diagnosed;
      if (!cause) continue;
      if (std::ranges::count(validate::classed_causes(last), cause->id) > 0) {
        ++counts.known;
        continue;
      }
      tell(flag, "accused of " + cause->sentence);
      ++counts.accused;
    }
  }

 private:
  void tell(const std::string& flag, const std::string& what) const {
    fmt::print(stderr, "seed {}, {}: {}\n", seed_, flag, what);
  }

  validate::Comparison compared(const Shot& shot, const RenderedShot& drawn,
                                validate::Standard standard) const {
    const Image ours = shade_all(random_.scene, shot, fragments_);
    standard.output_steps = drawn.output_steps;
    return compare(reference_, shot, ours, drawn.image, sensitivities(reference_, shot), standard);
  }

  static Outcome outcome_of(const validate::Comparison& c) {
    return c.coverage_unexplained > 0 ? Outcome::kDiffered : c.outcome();
  }

  void tell_of(const std::string& flag, const std::string& shot,
               const validate::Comparison& c) const {
    if (c.coverage_unexplained > 0) {
      tell(flag, fmt::format("{}: {} pixels covered by one", shot, c.coverage_unexplained));
    }
    for (const std::string& line : c.exceeded) tell(flag, fmt::format("{}: {}", shot, line));
    for (const validate::ClassShare& share : c.shares) {
      if (!share.exceeded) continue;
      tell(flag, fmt::format("{}: explained, {:.1f} %", shot, 100 * share.share()));
    }
  }

  std::optional<diagnosis::NamedCause> named_cause(const Image& picture, bool limited) const {
    const diagnosis::Diagnosis d =
        diagnosis::diagnose({random_.scene, shots_.back(), picture, random_.knot, limited, true});
    if (d.verdict != diagnosis::Diagnosis::Verdict::kNamed) return {};
    return d.cause.causes.front();
  }

  const RandomScene& random_;
  std::uint64_t seed_;
  Grid<Fragment> fragments_;
  validate::Reference reference_;
  std::vector<Shot> shots_;
};

}  // namespace

std::vector<AgreeingCounts> count_agreeing(long long scenes, std::uint64_t seed,
                                           const std::vector<std::string>& renderers) {
  std::vector<AgreeingCounts> all;
  for (const std::string& flag : renderers) all.push_back({.renderer = flag});
  for (long long i = 0; i < scenes; ++seed) {
    const RandomScene random = random_scene(seed);
    const Judge judge(random, seed);
    if (!judge.sees_anything()) continue;
    ++i;
    for (AgreeingCounts& counts : all) judge.count(counts.renderer, counts);
  }
  return all;
}

}  // namespace lumaknot::verdicts
