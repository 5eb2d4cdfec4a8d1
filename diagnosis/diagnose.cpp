#include "diagnosis/diagnose.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "diagnosis/noise.h"
#include "diagnosis/search.h"

namespace lumaknot::diagnosis {
namespace {

constexpr long long kMaxPixels = 13'000;   // compared: more say nothing new
constexpr long long kMaxScreened = 6'000;  // to find out which causes are worth a closer look

Situation situation_of(const Case& given, const Facts& facts) {
  Situation s;
  s.setup.mesh = std::make_shared<const TriangleMesh>(given.scene.mesh);
  s.setup.texture = std::make_shared<const Texture>(given.scene.texture);
  s.setup.view = given.scene.view;
  s.setup.view.material = given.shot.material;
  s.setup.stage = given.shot.stage;
  s.asked = given.scene.view.image;
  s.setup.view.image = {given.theirs.width, given.theirs.height, 1};
  s.setup.picture.samples = given.scene.view.image.samples;
  s.knot = given.knot;
  s.eight_bits = facts.depth == Depth::kEightBits;
  s.soft_edges = facts.soft_edges;
  Vec3d low = given.scene.mesh.positions.front(), high = low;
  for (const Vec3d& p : given.scene.mesh.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  s.centre = (low + high) * 0.5;
  s.extent = length(high - low) * 0.5;
  return s;
}

/// Our and their colours where both cover the whole pixel.
std::vector<std::pair<Vec3d, Vec3d>> colors_of_both(const Target& target, const Drawn& ours) {
  std::vector<std::pair<Vec3d, Vec3d>> both;
  for (std::size_t i = 0; i < ours.coverage.size(); ++i) {
    if (ours.coverage[i] < 1 || target.coverage[i] < 1) continue;
    both.emplace_back(ours.colors[i], target.colors[i]);
  }
  return both;
}

/// The pixels that the target or our picture covers.
std::size_t counted_pixels(const Target& target, const Drawn& ours) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < ours.coverage.size(); ++i) {
    count += ours.coverage[i] > 0 || target.coverage[i] > 0;
  }
  return std::max<std::size_t>(count, 1);
}

Explained explained(const Explanation& e) {
  Explained result{{}, e.score};
  for (std::size_t i = 0; i < e.causes.size(); ++i) {
    const Hypothesis& h = *e.causes[i];
    NamedCause cause{h.id, h.sentence(e.values[i]), {}, h.rung};
    for (std::size_t p = 0; p < h.parameters.size(); ++p) {
      cause.numbers.push_back({h.parameters[p].name, e.values[i][p], h.parameters[p].start});
    }
    result.causes.push_back(std::move(cause));
  }
  return result;
}

/// Alpha that says nothing where it should: known without a search.
std::optional<NamedCause> alpha_cause(const Case& given, const Facts& facts) {
  if (!given.expects_alpha || facts.has_alpha) return {};
  if (facts.alpha <= 0) return NamedCause{"alpha-zero", "an alpha of 0 everywhere", {}};
  return NamedCause{"alpha-opaque", "an alpha of 1 everywhere", {}};
}

/// White noise on our picture: seen from every pixel, as neighbours tell.
std::optional<NamedCause> noise_cause(const Case& given, const Situation& situation) {
  const Target target =
      target_of(given.theirs, given.limited, 1LL * given.theirs.width * given.theirs.height);
  const Drawer drawer(target.grid);
  const std::optional<double> deviation =
      white_noise(target, draw({target, situation.setup, drawer, 1}, {}));
  if (!deviation) return {};
  return NamedCause{"noise",
                    fmt::format("noise with a standard deviation of {:.2g}", *deviation),
                    {{"deviation", *deviation, 0}}};
}

/// What explains as well as the best: their scores differ by less than noise does.
void keep_equivalents(const Found& found, Diagnosis& diagnosis) {
  const double best = found.accepted.front().score.value;
  for (std::size_t i = 1; i < found.accepted.size(); ++i) {
    const Explanation& e = found.accepted[i];
    if (e.score.value < best + 0.02) diagnosis.equivalents.push_back(explained(e));
  }
}

}  // namespace

Diagnosis diagnose(const Case& given) {
  const Target target = target_of(given.theirs, given.limited, kMaxPixels);
  Situation situation = situation_of(given, target.facts);
  const Drawer drawer(target.grid);
  Problem problem{target, situation.setup, drawer, 1};
  const Drawn ours = draw(problem, {});
  problem.pixels = counted_pixels(target, ours);
  Diagnosis result;
  result.facts = target.facts;
  result.as_given = score_of(target, errors_of(target, ours), problem.pixels);
  const std::optional<NamedCause> alpha = alpha_cause(given, target.facts);
  if (agrees(problem, ours)) {
    result.verdict = alpha ? Diagnosis::Verdict::kNamed : Diagnosis::Verdict::kAgrees;
    result.cause = {alpha ? std::vector{*alpha} : std::vector<NamedCause>{}, result.as_given};
    return result;
  }
  situation.negative = std::ranges::any_of(
      ours.colors, [](const Vec3d& c) { return std::min({c.x, c.y, c.z}) < 0; });
  situation.seen = colors_of_both(target, ours);
  const std::vector<Hypothesis> all = hypotheses(situation);
  const Target coarse_target = target_of(given.theirs, given.limited, kMaxScreened);
  const Drawer coarse_drawer(coarse_target.grid);
  const std::size_t share = target.grid.size() / coarse_target.grid.size();
  const Problem coarse{coarse_target, situation.setup, coarse_drawer,
                       std::max<std::size_t>(problem.pixels / share, 1)};
  problem.coarse = &coarse;
  Found found = search_singles(problem, all, given.progress);
  if (found.accepted.empty()) {
    if (const std::optional<NamedCause> noise = noise_cause(given, situation)) {
      result.verdict = Diagnosis::Verdict::kNamed;
      result.cause = {{*noise}, result.as_given};
      if (alpha) result.cause.causes.push_back(*alpha);
      return result;
    }
    found = search_pairs(problem, all, found, given.progress);
  }
  if (!found.accepted.empty()) {
    result.verdict = Diagnosis::Verdict::kNamed;
    result.cause = explained(found.accepted.front());
    keep_equivalents(found, result);
    if (alpha) result.cause.causes.push_back(*alpha);
  } else if (found.nearest) {
    result.cause = explained(*found.nearest);
  }
  return result;
}

std::string sentence_of(const Diagnosis& diagnosis) {
  std::vector<std::string> causes;
  causes.reserve(diagnosis.cause.causes.size());
  for (const NamedCause& c : diagnosis.cause.causes) causes.push_back(c.sentence);
  const std::string named = fmt::format("{}", fmt::join(causes, " and "));
  switch (diagnosis.verdict) {
    case Diagnosis::Verdict::kAgrees:
      return "nothing: they agree";
    case Diagnosis::Verdict::kNamed:
      return fmt::format("{} (residual {:.1g})", named, diagnosis.cause.score.median);
    case Diagnosis::Verdict::kUnknown:
      break;
  }
  if (named.empty()) return "unknown";
  return fmt::format("unknown; nearest: {}, which explains {:.0f} %", named,
                     100 * diagnosis.cause.score.explained);
}

}  // namespace lumaknot::diagnosis
