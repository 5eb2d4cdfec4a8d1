// The orientation of rings along the centre line.
#include <limits>

#include "math/angle.h"
#include "meshgen/frames.h"
#include "study/stability/regions.h"
#include "study/stability/test_scenes.h"
#include "system/error.h"

namespace lumaknot::stability {
namespace {

constexpr double kSideDegrees = 360.0 / 40;  // degrees per side of figure2's tube
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Spine spine_of(const KnotSpec& knot) { return Spine(components(knot).front()); }

std::vector<RingFrame> frames_of(const KnotSpec& knot) {
  const Spine spine = spine_of(knot);
  return ring_frames(spine, knot.frames, spine.arc_lengths(knot.segments));
}

/// The largest turn of a frame about the centre line to the next ring, in degrees; infinite if the
/// rule leaves it undefined.
double largest_turn(const KnotSpec& knot) try {
  const std::vector<RingFrame> frames = frames_of(knot);
  double largest = 0;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    largest = std::max(largest, std::abs(twist({frames[i], frames[i + 1]})) * kDegrees);
  }
  return largest;
} catch (const Error&) {
  return kInfinity;
}

/// The camera over the axis' side of the knot, where the centre line bends least.
Scene inner_view(const KnotSpec& knot) {
  Scene scene = knot_scene(knot, Material{});
  scene.view.camera = {.position = {0, -1.6, 1.9}, .target = {0, 0, 0}};
  return scene;
}

/// The default knot with another minor radius and frames.
KnotSpec wound(double minor_radius, FrameRule frames, double tube_radius = 0.12) {
  KnotSpec knot = sketch_knot();
  knot.segments = 768;
  knot.minor_radius = minor_radius;
  knot.tube_radius = tube_radius;
  knot.frames = frames;
  return knot;
}

/// A frame rule that turns too fast as the minor radius changes.
Region turning(FrameRule rule) {
  const auto turn = [](FrameRule frames) {
    return [frames](double w) { return largest_turn(wound(w, frames)); };
  };
  const auto picture = [](FrameRule frames) {
    return [frames](double w, int side) { return draw(inner_view(wound(w, frames)), side); };
  };
  Region region;
  region.group = "Frames";
  region.remedy =
      "rotation-minimizing frames (the default): they turn with the torus, never about "
      "the line itself";
  region.measured = "largest turn from a ring to the next of 768, degrees";
  region.limit = kSideDegrees;
  region.error = turn(rule);
  region.guarded = turn(FrameRule::kRotationMinimizing);
  region.sketch = picture(rule);
  region.guarded_sketch = picture(FrameRule::kRotationMinimizing);
  return region;
}

Region frenet_inflection() {
  Region region = turning(FrameRule::kFrenet);
  region.name = "frenet-inflection";
  region.method = "Frenet frames";
  region.reason =
      "the principal normal has no direction where the curvature is zero, at w = R p^2 / (p^2 + "
      "q^2) = 0.3077 on the inner side of the (2,3) knot, and turns by 180 degrees near by";
  region.sweep = {"winding radius w, R = 1", 0.4, 0.3077};
  region.shown_holds = 0.4;
  region.shown_fails = 0.3085;
  return region;
}

Region fixed_up_vertical() {
  Region region = turning(FrameRule::kFixedUp);
  region.name = "fixed-up-vertical";
  region.method = "frames from a fixed up direction";
  region.reason =
      "+Z projected across the tangent vanishes where the line runs vertically, as the (2,3) knot "
      "does near the axis when its winding is nearly as wide as its ring";
  region.sweep = {"winding radius w, R = 1", 0.4, 0.999};
  region.shown_holds = 0.4;
  region.shown_fails = 0.96;
  region.sketch = [](double w, int side) {
    return draw(inner_view(wound(w, FrameRule::kFixedUp, 0.05)), side);
  };
  region.guarded_sketch = [](double w, int side) {
    return draw(inner_view(wound(w, FrameRule::kRotationMinimizing, 0.05)), side);
  };
  return region;
}

RingFrame turned(const RingFrame& f, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {f.position, f.tangent, f.normal * c + f.binormal * s, f.binormal * c - f.normal * s};
}

/// The knot's frames without what closes the loop: each turned back by its share of the twist.
std::vector<RingFrame> unclosed_frames(const KnotSpec& knot) {
  const Spine spine = spine_of(knot);
  const std::vector<double> arc_lengths = spine.arc_lengths(knot.segments);
  std::vector<RingFrame> frames = spine.frames(arc_lengths);
  const double all = twist(frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i] = turned(frames[i], all * arc_lengths[i] / spine.length());
  }
  return frames;
}

/// The angle between the first frame and the last, which are at one place, in degrees.
double gap(const std::vector<RingFrame>& frames) {
  const RingFrame &a = frames.front(), &b = frames.back();
  return std::abs(std::atan2(dot(b.normal, a.binormal), dot(b.normal, a.normal))) * kDegrees;
}

/// A tube with given frames, seen where its ends meet.
Image draw_seam(const std::vector<RingFrame>& frames, int side) {
  Scene scene = knot_scene(Material{});
  scene.mesh = tube_of(frames, 0.18, 40);
  scene.view.camera = {.position = {2.6, -0.6, 1.0}, .target = {1.3, 0, 0}, .up = {0, 0, 1}};
  scene.view.lights = {PointLight{.position = {4, -3, 3}, .color = {}, .falloff = {}}};
  return draw(scene, side);
}

Region naive_closing() {
  Region region;
  region.name = "naive-closing";
  region.group = "Frames";
  region.method = "rotation-minimizing frames, ends sewn as they are";
  region.reason =
      "after one loop the frame that turns least misses itself by the holonomy, which only closed "
      "curves of special shape have at zero; texture and quads break at the seam";
  region.remedy = "spread the holonomy over the arc length, as our frames do";
  region.sweep = {"winding radius w, R = 1", 0.002, 0.6};
  region.measured = "gap between the first ring and the last, degrees (half a side is 4.5)";
  region.limit = kSideDegrees / 2;
  region.error = [](double w) {
    return gap(unclosed_frames(wound(w, FrameRule::kRotationMinimizing)));
  };
  region.guarded = [](double w) {
    return gap(frames_of(wound(w, FrameRule::kRotationMinimizing)));
  };
  region.sketch = [](double w, int side) {
    return draw_seam(unclosed_frames(wound(w, FrameRule::kRotationMinimizing)), side);
  };
  region.guarded_sketch = [](double w, int side) {
    return draw_seam(frames_of(wound(w, FrameRule::kRotationMinimizing)), side);
  };
  region.shown_fails = 0.4;
  region.shown_holds = 0.02;
  return region;
}

double angle_between(const Vec3d& a, const Vec3d& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * kDegrees;
}

/// The largest angle between a ring's plane and the one normal to the centre line, in degrees.
double largest_tilt(const KnotSpec& knot, const std::vector<RingFrame>& frames) {
  const Curve curve = components(knot).front();
  double largest = 0;
  for (int i = 0; i <= knot.segments; ++i) {
    const Vec3d tangent = curve_point(curve, ring_parameter(i, knot.segments)).first;
    const Vec3d across = cross(frames[std::size_t(i)].normal, frames[std::size_t(i)].binormal);
    largest = std::max(largest,
                       std::min(angle_between(across, tangent), angle_between(-across, tangent)));
  }
  return largest;
}

KnotSpec thin_knot(int q, FrameRule frames) {
  KnotSpec knot = sketch_knot();
  knot.segments = 1536;
  knot.q = q;
  knot.tube_radius = 0.025;
  knot.frames = frames;
  return knot;
}

Region difference_frames() {
  const auto tilt = [](FrameRule rule) {
    return [rule](double q) {
      const KnotSpec knot = thin_knot(int(q), rule);
      return largest_tilt(knot, frames_of(knot));
    };
  };
  const auto picture = [](FrameRule rule) {
    return [rule](double q, int side) { return draw(inner_view(thin_knot(int(q), rule)), side); };
  };
  Region region;
  region.name = "finite-difference-frames";
  region.group = "Frames";
  region.method = "three.js's frames: a difference over 0.01 radians of longitude";
  region.reason =
      "the difference is the tangent half a step farther on; a knot that winds more turns away "
      "from it by more, so rings tilt and the tube gets thin and badly lit";
  region.remedy = "the exact derivative of the centre line, as all other frame rules use";
  region.sweep = {"windings q of the (2,q) knot", 1, 60, false, true};
  region.measured = "largest tilt of a ring, degrees";
  region.limit = 2;
  region.error = tilt(FrameRule::kThree);
  region.guarded = tilt(FrameRule::kRotationMinimizing);
  region.sketch = picture(FrameRule::kThree);
  region.guarded_sketch = picture(FrameRule::kRotationMinimizing);
  region.shown_holds = 3;
  region.shown_fails = 41;
  return region;
}

Vec3d in_float(const Vec3d& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// The exact frames, their rings normal to the difference of two points h apart, in float.
std::vector<RingFrame> tilted_frames(const KnotSpec& knot, double h) {
  const Curve curve = components(knot).front();
  std::vector<RingFrame> frames = frames_of(knot);
  for (int i = 0; i <= knot.segments; ++i) {
    const double t = ring_parameter(i, knot.segments);
    const Vec3d step =
        in_float(curve_point(curve, t + h).position) - in_float(curve_point(curve, t).position);
    RingFrame& frame = frames[std::size_t(i)];
    frame.tangent = normalize(step);
    frame.normal = normalize(frame.normal - frame.tangent * dot(frame.normal, frame.tangent));
    frame.binormal = cross(frame.normal, frame.tangent);
  }
  return frames;
}

Region difference_step(double from, double to) {
  const auto knot = [] { return wound(0.4, FrameRule::kRotationMinimizing, 0.18); };
  Region region;
  region.group = "Frames";
  region.method = "tangents from the difference of two points in float";
  region.remedy = "the exact derivative of the centre line";
  region.sweep = {"step h of the parameter, radians", from, to, true};
  region.measured = "largest tilt of a ring, degrees";
  region.limit = 2;
  region.error = [knot](double h) { return largest_tilt(knot(), tilted_frames(knot(), h)); };
  region.guarded = [knot](double) { return largest_tilt(knot(), frames_of(knot())); };
  region.sketch = [knot](double h, int side) {
    Scene scene = inner_view(knot());
    scene.mesh = tube_of(tilted_frames(knot(), h), 0.18, 32);
    return draw(scene, side);
  };
  region.guarded_sketch = [knot](double, int side) { return draw(inner_view(knot()), side); };
  region.guarded_shows = [](double) { return "no step"; };
  return region;
}

Region short_step() {
  Region region = difference_step(1e-3, 1e-7);
  region.name = "difference-step-short";
  region.reason =
      "positions near 1 are known to 6e-8 in float; what is left of their difference is noise as "
      "large as the step is short";
  region.shown_holds = 1e-3;
  region.shown_fails = 5e-7;
  return region;
}

Region long_step() {
  Region region = difference_step(1e-3, 1);
  region.name = "difference-step-long";
  region.reason = "the chord of a curve is not its tangent: the error grows with the step";
  region.shown_holds = 1e-3;
  region.shown_fails = 0.5;
  return region;
}

}  // namespace

std::vector<Region> frame_regions() {
  return {frenet_inflection(), fixed_up_vertical(), naive_closing(),
          difference_frames(), short_step(),        long_step()};
}

}  // namespace lumaknot::stability
