#include "bench/verdicts/pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>

#include "diagnosis/diagnose.h"
#include "render/reference.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "system/known.h"
#include "validate/self_test/self_test.h"

namespace lumaknot::verdicts {
namespace {

using validate::Fault;

KnotSpec small_knot() {
  KnotSpec knot = std::get<KnotSpec>(known(builtin_scene("figure2")).mesh);
  knot.segments = 240;
  knot.sides = 24;
  return knot;
}

/// Faults that say something beside another: one that hides the other, or that only looks like a
/// part of it, can't be named.
bool joins(const Fault& fault) {
  if (fault.names.empty()) return false;
  const std::string& name = fault.names.front();
  for (const std::string_view hiding : {"knot-", "bits-", "noise", "tone-curve", "light-missing"}) {
    if (name.starts_with(hiding)) return false;
  }
  return true;
}

class Pairs {
 public:
  Pairs() {
    scene_.view.image = {112, 112, 1};
    faults_ = validate::planted_faults(scene_, &knot_);
    std::erase_if(faults_, [](const Fault& f) { return !joins(f); });
  }

  std::size_t size() const { return faults_.size(); }
  const Fault& fault(std::size_t i) const { return faults_[i]; }

  Image drawn(const std::vector<const Fault*>& faults) const {
    Scene scene = scene_;
    for (const Fault* f : faults) {
      if (f->scene) f->scene(scene, &knot_);
    }
    const Shot shot{"final", Stage::kFinal, scene.view.material};
    Image image = shade_all(scene, shot, visible_fragments(scene));
    for (const Fault* f : faults) {
      if (f->picture) image = f->picture(image);
    }
    return image;
  }

  diagnosis::Diagnosis diagnosed(const Image& image, bool eight_bits) const {
    const Shot shot{"final", Stage::kFinal, scene_.view.material};
    return diagnosis::diagnose({scene_, shot, image, knot_, eight_bits, true});
  }

 private:
  KnotSpec knot_ = small_knot();
  Scene scene_{knot_mesh(knot_), bricks(), known(builtin_scene("figure2")).view};
  std::vector<Fault> faults_;
};

Image in_eight_bits(Image image) {
  for (RgbaPixel& p : image.pixels) {
    for (float* v : {&p.color.r, &p.color.g, &p.color.b}) {
      *v = std::round(std::clamp(*v, 0.0f, 1.0f) * 255) / 255;
    }
  }
  return image;
}

bool same(const Image& a, const Image& b) {
  return std::ranges::equal(a.pixels, b.pixels, [](const RgbaPixel& p, const RgbaPixel& q) {
    const double apart = largest_magnitude(to_vec(p.color) - to_vec(q.color));
    return p.coverage == q.coverage && apart < 1e-3;
  });
}

bool names(const diagnosis::Explained& explained, const Fault& fault) {
  return std::ranges::any_of(explained.causes, [&](const diagnosis::NamedCause& cause) {
    return std::ranges::count(fault.names, cause.id) > 0;
  });
}

/// Whether one of the explanations that can't be told apart has both.
bool has_both(const diagnosis::Diagnosis& d, const Fault& a, const Fault& b) {
  const auto both = [&](const diagnosis::Explained& e) { return names(e, a) && names(e, b); };
  return both(d.cause) || std::ranges::any_of(d.equivalents, both);
}

}  // namespace

PairCounts count_pairs(long long count, std::uint64_t seed, bool eight_bits) {
  const Pairs pairs;
  std::mt19937_64 random(seed);
  PairCounts counts;
  while (counts.pairs < count) {
    const Fault& a = pairs.fault(random() % pairs.size());
    const Fault& b = pairs.fault(random() % pairs.size());
    // Two of one kind are one, and a finished picture has one history.
    if (a.names.front() == b.names.front() || (a.picture && b.picture)) continue;
    const Image both = pairs.drawn({&a, &b});
    if (same(both, pairs.drawn({&a})) || same(both, pairs.drawn({&b}))) {
      ++counts.unseen;
      continue;
    }
    ++counts.pairs;
    const std::clock_t start = std::clock();
    const diagnosis::Diagnosis d =
        pairs.diagnosed(eight_bits ? in_eight_bits(both) : both, eight_bits);
    counts.seconds += double(std::clock() - start) / CLOCKS_PER_SEC;
    const bool is_named = d.verdict == diagnosis::Diagnosis::Verdict::kNamed;
    const bool right = is_named && has_both(d, a, b);
    counts.both_named += right;
    counts.wrong += is_named && !right;
    counts.unknown += !is_named;
    if (!right) {
      fmt::print(stderr, "{} and {}: {}\n", a.what, b.what, sentence_of(d));
    }
  }
  return counts;
}

}  // namespace lumaknot::verdicts
