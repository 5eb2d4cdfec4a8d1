#include "study/plan/pruning.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>
#include <set>

#include "render/shading.h"
#include "study/measure/method.h"
#include "system/process.h"

namespace lumaknot::plan {
namespace {

constexpr double kNothing = 1e-9;     // rounding
constexpr std::size_t kChunk = 4096;  // points between two checks for Ctrl-C

/// The colours that a view and a texture give to points, in double.
class Colors {
 public:
  explicit Colors(const SimplifiedScene& simplified)
      : scene_{{}, simplified.texture, simplified.view},
        shot_{"final", Stage::kFinal,
              measure::true_material(simplified.view.material, simplified.view.material.space)},
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
double largest_change(const SimplifiedScene& simplified, std::span<const Fragment> points,
                      std::span<const Vec3d> colors, double enough) {
  const Colors changed(simplified);
  double max = 0;
  for (std::size_t begin = 0; begin < points.size() && max <= enough; begin += kChunk) {
    check_interrupted();
    using Range = oneapi::tbb::blocked_range<std::size_t>;
    const Range chunk(begin, std::min(begin + kChunk, points.size()));
    max = std::max(max, oneapi::tbb::parallel_reduce(
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
  return max;
}

std::vector<Vec3d> colors_of(const SimplifiedScene& simplified, std::span<const Fragment> points) {
  const Colors colors(simplified);
  std::vector<Vec3d> all(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % kChunk == 0) check_interrupted();
    all[i] = colors.at(points[i]);
  }
  return all;
}

/// Prunes one thing after the other.
class Dropper {
 public:
  Dropper(const Scene& scene, std::span<const Fragment> seen)
      : seen_(seen),
        result_{whole(scene), {}, {}, 0},
        colors_(colors_of(result_.simplified, seen)) {}

  /// Applies every simplification whose change, with all before, is at most `limit`.
  void go(double limit) {
    result_.kept.clear();
    std::set<std::string> refused;
    for (bool again = true; again;) {
      again = false;
      for (const Simplification& s : simplifications(result_.simplified, seen_)) {
        if (refused.contains(s.what)) continue;
        again = make(s, limit);
        if (again) break;  // the rest is another list
        refused.insert(s.what);
      }
    }
  }

  Pruning result() { return std::move(result_); }

 private:
  bool make(const Simplification& s, double limit) {
    SimplifiedScene next = result_.simplified;
    s.apply(next);
    const double change = largest_change(next, seen_, colors_, limit);
    if (!(change <= limit)) {
      result_.kept.push_back({s.what, s.bound, change});
      return false;
    }
    const std::vector<Vec3d> before = colors_of(result_.simplified, seen_);
    result_.dropped.push_back({s.what, s.bound, largest_change(next, seen_, before, 1e30)});
    result_.change = change;
    result_.simplified = std::move(next);
    return true;
  }

  std::span<const Fragment> seen_;
  Pruning result_;
  std::vector<Vec3d> colors_;  // of the scene as it is
};

}  // namespace

Pruning drop(const Scene& scene, std::span<const Fragment> seen, double share) {
  Dropper dropper(scene, seen);
  dropper.go(kNothing);
  dropper.go(share);
  return dropper.result();
}

}  // namespace lumaknot::plan
