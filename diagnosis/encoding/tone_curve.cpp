/// A tone curve: one that is known, or any that all channels are sent through.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/cause.h"
#include "diagnosis/least_squares.h"

namespace lumaknot::diagnosis {

namespace {

struct Known {
  std::string_view id, sentence;
  Tone tone;
};

constexpr std::array<Known, 7> kKnown{
    {{"tone-reinhard", "Reinhard's tone curve, c / (1 + c)", Tone::kReinhard},
     {"tone-aces", "Narkowicz's fit of the ACES tone curve", Tone::kAces},
     {"tone-aces-fitted", "Hill's fit of the ACES tone curve, as in three.js", Tone::kAcesFitted},
     {"tone-hable", "Hable's tone curve of Uncharted 2", Tone::kHable},
     {"tone-neutral", "the tone curve PBR Neutral", Tone::kNeutral},
     {"tone-agx", "the tone curve AgX, as in three.js", Tone::kAgx},
     {"tone-cineon", "the tone curve of Cineon film", Tone::kCineon}}};

constexpr std::size_t kPoints = 41;

/// The values of the curve that maps our colours to theirs, by least squares.
std::vector<double> regressed(const ToneSpline& spline, const Situation& situation) {
  std::vector<double> a(kPoints * kPoints, 0.0), b(kPoints, 0.0);
  for (const auto& [ours, theirs] : situation.seen) {
    const std::array<double, 3> x = components(ours), y = components(theirs);
    for (std::size_t c = 0; c < 3; ++c) {
      const ToneSpline::Weights w = spline.weights(x[c], kPoints);
      for (std::size_t i = 0; i < 4 && w.first + i < kPoints; ++i) {
        b[w.first + i] += w.of[i] * y[c];
        for (std::size_t j = 0; j < 4 && w.first + j < kPoints; ++j) {
          a[(w.first + i) * kPoints + w.first + j] += w.of[i] * w.of[j];
        }
      }
    }
  }
  // As straight as what is seen allows: there may be colours that no pixel has.
  const double stiffness = 1e-6 * double(situation.seen.size());
  for (std::size_t k = 1; k + 1 < kPoints; ++k) {
    constexpr std::array<double, 3> kBend{1, -2, 1};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        a[(k - 1 + i) * kPoints + k - 1 + j] += stiffness * kBend[i] * kBend[j];
      }
    }
  }
  return solve(std::move(a), std::move(b), 1e-9);
}

/// A tone curve never makes a brighter colour darker.
std::vector<double> rising(std::vector<double> values) {
  for (std::size_t i = 1; i < values.size(); ++i) values[i] = std::max(values[i], values[i - 1]);
  return values;
}

/// Any curve, the last to be tried: its numbers may imitate much.
std::vector<Hypothesis> unknown_curve(const Situation& situation) {
  ToneSpline spline{0, 0};
  for (const auto& [ours, theirs] : situation.seen) {
    spline.low = std::min({spline.low, ours.x, ours.y, ours.z});
    spline.high = std::max({spline.high, ours.x, ours.y, ours.z});
  }
  if (spline.high <= spline.low) return {};
  spline.low = -std::sqrt(-spline.low);
  spline.high = std::sqrt(spline.high);
  const std::vector<double> values = rising(regressed(spline, situation));
  Hypothesis h =
      discrete("tone-curve", Rung::kEncoding,
               fmt::format("a tone curve that makes 0.18 {:.3g}, 0.5 {:.3g} and 1 {:.3g}",
                           spline.at(0.18, values), spline.at(0.5, values), spline.at(1, values)),
               [spline, values](Setup& s) {
                 s.color.spline = spline;
                 s.color.spline_values = values;
               });
  h.costly = true;
  return {h};
}

}  // namespace

std::vector<Hypothesis> tone_curve(const Situation& situation) {
  std::vector<Hypothesis> all = unknown_curve(situation);
  for (const Known& known : kKnown) {
    all.push_back(discrete(std::string(known.id), Rung::kEncoding, std::string(known.sentence),
                           [tone = known.tone](Setup& s) { s.color.tone = tone; }));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
