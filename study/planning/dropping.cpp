#include "study/planning/dropping.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>
#include <set>

#include "render/shading.h"
#include "study/method.h"
#include "validate/process.h"

namespace lumaknot {
namespace {

constexpr double kNothing = 1e-9;     // rounding
constexpr std::size_t kChunk = 4096;  // points between two looks at Ctrl-C

/// The colours that a view and a texture give to points, in double.
class Colors {
 public:
  explicit Colors(const Lean& lean)
      : scene_{{}, lean.texture, lean.view},
        shot_{"final", Stage::kFinal, true_material(lean.view.material, lean.view.material.space)},
        shading_(scene_, shot_) {}
  Colors(const Colors&) = delete;
  Colors& operator=(const Colors&) = delete;

  Vec3d at(const Fragment& point) const { return saturate(shading_.color(point)); }

 private:
  Scene scene_;
  Shot shot_;
  Shading shading_;
};

/// The largest change, or that of the first points that exceed `enough`.
double largest_change(const Lean& lean, std::span<const Fragment> points,
                      std::span<const Vec3d> colors, double enough) {
  const Colors changed(lean);
  double most = 0;
  for (std::size_t begin = 0; begin < points.size() && most <= enough; begin += kChunk) {
    check_interrupted();
    using Range = oneapi::tbb::blocked_range<std::size_t>;
    const Range chunk(begin, std::min(begin + kChunk, points.size()));
    most = std::max(most, oneapi::tbb::parallel_reduce(
                              chunk, 0.0,
                              [&](const Range& part, double worst) {
                                for (std::size_t i = part.begin(); i < part.end(); ++i) {
                                  worst = std::max(
                                      worst, largest_magnitude(changed.at(points[i]) - colors[i]));
                                }
                                return worst;
                              },
                              [](double a, double b) { return std::max(a, b); }));
  }
  return most;
}

std::vector<Vec3d> colors_of(const Lean& lean, std::span<const Fragment> points) {
  const Colors colors(lean);
  std::vector<Vec3d> all(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kChunk == 0) check_interrupted();
    all[i] = colors.at(points[i]);
  }
  return all;
}

/// Dropping one thing after the other.
class Dropper {
 public:
  Dropper(const Scene& scene, std::span<const Fragment> seen)
      : seen_(seen), result_{whole(scene), {}, {}, 0}, colors_(colors_of(result_.lean, seen)) {}

  /// Makes every simplification whose change, with all before, is at most `limit`.
  void go(double limit) {
    result_.kept.clear();
    std::set<std::string> refused;
    for (bool again = true; again;) {
      again = false;
      for (const Simplification& s : simplifications(result_.lean, seen_)) {
        if (refused.contains(s.what)) continue;
        again = make(s, limit);
        if (again) break;  // what is left is another list
        refused.insert(s.what);
      }
    }
  }

  Dropping result() { return std::move(result_); }

 private:
  bool make(const Simplification& s, double limit) {
    Lean next = result_.lean;
    s.apply(next);
    const double change = largest_change(next, seen_, colors_, limit);
    if (!(change <= limit)) {
      result_.kept.push_back({s.what, s.bound, change});
      return false;
    }
    const std::vector<Vec3d> before = colors_of(result_.lean, seen_);
    result_.dropped.push_back({s.what, s.bound, largest_change(next, seen_, before, 1e30)});
    result_.change = change;
    result_.lean = std::move(next);
    return true;
  }

  std::span<const Fragment> seen_;
  Dropping result_;
  std::vector<Vec3d> colors_;  // of the scene as it is
};

}  // namespace

Dropping drop(const Scene& scene, std::span<const Fragment> seen, double share) {
  Dropper dropper(scene, seen);
  dropper.go(kNothing);
  dropper.go(share);
  return dropper.result();
}

}  // namespace lumaknot
