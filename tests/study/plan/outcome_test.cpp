// Plans, held to rays of the test's own. No time is expected of anything.
#include "study/plan/outcome.h"

#include <gmock/gmock.h>

#include <cmath>

#include "exporters/image/file.h"
#include "math/angle.h"
#include "render/fast/renderer.h"
#include "scene/json.h"
#include "study/measure/method_words.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "system/process.h"
#include "tests/study/plan/testing.h"

namespace lumaknot::plan {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;

class Plans : public ::testing::Test {
 protected:
  Plan plan(const SceneSpec& spec, const Tolerance& tolerance = {}, bool exhaustive = false) {
    return make_plan({made(spec), spec, tolerance, exhaustive, 1}, folder_.path(), {},
                     [&](const std::string& line) { told_ += line; });
  }
  PrivateFolder folder_;
  std::string told_;
};

/// The plan's scene read from its JSON and drawn as its arguments tell.
Image drawn(const Plan& plan) {
  const SceneSpec spec = scene_from_json(scene_to_json(plan.simplified), "the plan");
  const std::vector<std::string> arguments = render_arguments(plan.chosen.method);
  if (arguments.empty()) return render(made(spec));
  fast::Options options;
  options.filter = arguments[2] == "trilinear" ? Filter::kTrilinear : Filter::kBilinear;
  options.samples = std::stoi(arguments[4]);
  options.cull_back_faces = arguments.size() == 6 && arguments[5] == "--cull";
  Image image;
  fast::Renderer(made(spec), options).draw(image);
  return image;
}

/// How deep the way between two points leads into the tube of a knot, by the points of its centre
/// line.
double depth_of_way(const KnotSpec& knot, const Vec3d& from, const Vec3d& to) {
  constexpr int kPoints = 4000;
  const Vec3d method = to - from;
  double nearest = knot.tube_radius;
  for (const Curve& line : centre_lines(knot)) {
    for (int i = 0; i < kPoints; ++i) {
      const Vec3d point = curve_point(line, kTurn * i / kPoints).position;
      const double along = std::clamp(dot(point - from, method) / dot(method, method), 0.0, 1.0);
      nearest = std::min(nearest, length(from + method * along - point));
    }
  }
  return knot.tube_radius - nearest;
}

/// Of point truth: how far the pixel is from what 200 rays within the shift see, or meet next
/// behind a passage through the tube that is no deeper than what their distance leaves.
double distance_from_rays(const KnotSpec& knot, const exact::ExactPixels& pixels,
                          const Shading& shading, int x, int y, double shift,
                          const RgbaPixel& pixel) {
  constexpr int kRays = 200;
  std::array<double, 4> low{9, 9, 9, 9}, high{-9, -9, -9, -9};
  const auto take = [&](const exact::ExactFragment& seen) {
    const Vec3d c = saturate(shading.color(seen.fragment));
    const std::array<double, 4> value{c.x, c.y, c.z, seen.fragment.covered() ? 1.0 : 0.0};
    for (std::size_t i = 0; i < 4; ++i) {
      low[i] = std::min(low[i], value[i]);
      high[i] = std::max(high[i], value[i]);
    }
  };
  for (int k = 0; k < (shift > 0 ? kRays : 1); ++k) {  // Vogel's spiral
    const double r = shift * std::sqrt(double(k) / (kRays - 1)), a = 2.399963 * k;
    const double u = x + 0.5 + r * std::cos(a), v = y + 0.5 + r * std::sin(a);
    const exact::ExactFragment seen = pixels.at(u, v);
    take(seen);
    if (!seen.fragment.covered()) continue;
    const double depth = seen.fragment.depth;
    const exact::ExactFragment out = pixels.at(u, v, depth * (1 + 1e-9));
    if (!out.fragment.covered()) continue;
    const double deep = depth_of_way(knot, seen.fragment.position, out.fragment.position) /
                        (depth * pixels.pixel_width());
    if (deep <= shift - r) {
      take(out);
      take(pixels.at(u, v, out.fragment.depth * (1 + 1e-9)));
    }
  }
  const std::array<double, 4> value{pixel.color.r, pixel.color.g, pixel.color.b, pixel.coverage};
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double limited = std::clamp(value[i], 0.0, 1.0);
    worst = std::max({worst, low[i] - limited, limited - high[i]});
  }
  return worst;
}

/// The largest over all pixels.
double own_error(const SceneSpec& spec, const Image& image, double shift) {
  const Scene scene = made(spec);
  const exact::ExactPixels pixels(scene, knot_of(spec));
  const Shot shot{"final", Stage::kFinal, scene.view.material};
  const Shading shading(scene, shot);
  double worst = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const RgbaPixel& pixel = image.at(x, y);
      if (pixel.coverage == 0 && !pixels.at(x + 0.5, y + 0.5).fragment.covered()) continue;
      const double in_place = distance_from_rays(knot_of(spec), pixels, shading, x, y, 0, pixel);
      worst = std::max(
          worst, in_place <= 1.0 / 255
                     ? in_place
                     : distance_from_rays(knot_of(spec), pixels, shading, x, y, shift, pixel));
    }
  }
  return worst;
}

// The rays are a fiftieth of a pixel apart: towards the limb of a tube about three pixels in radius
// that leaves this much of the colour out.
constexpr double kBetweenRays = 0.004;

TEST_F(Plans, are_met_by_rays_that_the_plan_did_not_choose) {
  const SceneSpec spec = small_spec(48);
  const Plan p = plan(spec);
  ASSERT_TRUE(p.met);
  EXPECT_LE(own_error(spec, drawn(p), 0.25), 1.0 / 255 + kBetweenRays);
}

TEST_F(Plans, of_a_textured_scene_with_lights_to_drop_are_met_too) {
  SceneSpec spec = small_spec(48);
  spec.texture = Bricks{};
  spec.view.lights.push_back(DirectionalLight{{0, 0, -1}, {{1, 1, 1}, 5e-4}});
  spec.view.material.space = Space::kYiq;
  const Plan p = plan(spec);
  ASSERT_TRUE(p.met);
  EXPECT_EQ(p.simplified.view.lights.size(), 1u);
  EXPECT_LE(own_error(spec, drawn(p), 0.25), 1.0 / 255 + kBetweenRays);
}

TEST_F(Plans, draw_from_their_scene_the_picture_that_was_measured) {
  SceneSpec spec = small_spec(48);
  spec.view.material.space = Space::kYuv601;
  const Plan p = plan(spec);
  const Image again = drawn(p);
  ASSERT_EQ(again.pixels.size(), p.after.pixels.size());
  for (std::size_t i = 0; i < again.pixels.size(); ++i) {
    EXPECT_EQ(again.pixels[i].color, p.after.pixels[i].color);
    EXPECT_EQ(again.pixels[i].coverage, p.after.pixels[i].coverage);
  }
}

TEST_F(Plans, leave_out_back_faces_where_none_is_seen) {
  const Plan p = plan(small_spec(48));
  EXPECT_TRUE(p.chosen.method.culls);
  EXPECT_TRUE(p.met);
}

TEST_F(Plans, keep_back_faces_where_the_eye_is_inside_the_tube) {
  SceneSpec spec = small_spec(48);
  spec.view.camera.position = {1.4, 0, 0};  // on the centre line, along its tangent
  spec.view.camera.target = {1.4, 2.8, 1.2};
  const Plan p = plan(spec, {0.05, 1});
  EXPECT_FALSE(p.chosen.method.culls);
  EXPECT_GT(p.chosen.result.covered, 48 * 48 / 2);
}

TEST_F(Plans, of_a_looser_tolerance_need_fewer_triangles) {
  const SceneSpec spec = small_spec(48);
  const auto quads = [](const Plan& p) { return p.chosen.method.segments * p.chosen.method.sides; };
  const int fine = quads(plan(spec, {0.002, 0.1}));
  const int coarse = quads(plan(spec, {0.05, 1}));
  EXPECT_LT(coarse, fine / 2);
}

TEST_F(Plans, that_cannot_be_met_without_a_shift_blame_the_edges) {
  const Plan p = plan(small_spec(48), {1.0 / 255, 0});
  EXPECT_FALSE(p.met);
  ASSERT_FALSE(p.blamed.empty());
  EXPECT_GT(p.chosen.result.failing, 0);
  EXPECT_THAT(plan_text(p), HasSubstr("can't be met"));
  EXPECT_THAT(plan_text(p), HasSubstr("--shift"));
}

TEST_F(Plans, of_several_samples_choose_methods_that_have_them) {
  SceneSpec spec = small_spec(32);
  spec.view.image.samples = 2;
  const Plan p = plan(spec, {0.01, 0.25});
  ASSERT_TRUE(p.met);
  EXPECT_TRUE(p.area);
  EXPECT_GT(p.chosen.method.samples, 1);
}

TEST_F(Plans, searched_exhaustively_find_the_same_or_tell_the_ratio) {
  const Plan p = plan(small_spec(32), {0.01, 0.25}, true);
  ASSERT_TRUE(p.best_of_all);
  EXPECT_EQ(int(p.candidates.size()), p.considered);
  EXPECT_GT(p.time_to_best, 0);
  EXPECT_TRUE(p.best_of_all->result.met);
}

TEST_F(Plans, measure_nothing_again_that_the_folder_holds) {
  const SceneSpec spec = small_spec(32);
  const Plan first = plan(spec);
  const std::string held = read_file(folder_.path() / "measured.json", "measured.json");
  const Plan second = plan(spec);
  EXPECT_EQ(read_file(folder_.path() / "measured.json", "measured.json"), held);
  EXPECT_EQ(plan_json(second), plan_json(first));
  EXPECT_EQ(told_, "");
  plan(spec, {0.02, 0.25});
  EXPECT_THAT(told_, HasSubstr("measured again"));
}

TEST_F(Plans, count_as_kept_what_is_of_the_same_scene_and_tolerance) {
  const SceneSpec spec = small_spec(32);
  PlanJob job{made(spec), spec, {}, false, 1};
  EXPECT_EQ(measured_choices(job, folder_.path()), 0u);
  const Plan p = plan(spec);
  EXPECT_GE(measured_choices(job, folder_.path()), p.candidates.size());
  job.tolerance.color = 0.02;
  EXPECT_EQ(measured_choices(job, folder_.path()), 0u);
}

TEST_F(Plans, judge_the_scene_s_own_fast_picture_too) {
  SceneSpec spec = small_spec(32);
  spec.mesh = KnotSpec{.segments = 24, .sides = 4};
  const Plan coarse = plan(spec, {0.02, 0.25});
  EXPECT_FALSE(coarse.fast.met);
  EXPECT_TRUE(coarse.met);
  EXPECT_THAT(plan_json(coarse), HasSubstr("\"before_fast\": {\n    \"met\": false"));
  spec.mesh = KnotSpec{.segments = 900, .sides = 120};
  EXPECT_TRUE(plan(spec, {0.02, 0.25}).fast.met);
}

TEST_F(Plans, count_what_they_move_out_of_place_pixel_by_pixel) {
  SceneSpec spec = small_spec(48);
  spec.texture = Bricks{};
  const Plan p = plan(spec);
  // Either picture's pixels beyond the tolerance in place are those of both, and its own.
  EXPECT_EQ(p.reference.shifted + p.lost_in_place, p.chosen.result.shifted + p.won_in_place);
  EXPECT_GT(p.chosen.result.shifted, 0);
}

/// One colour on a coarse grid of its own: only edges and highlights move with the grid.
SceneSpec smooth_spec() {
  SceneSpec spec = small_spec(48);
  spec.mesh = KnotSpec{.segments = 96, .sides = 8};
  return spec;
}

TEST_F(Plans, with_a_share_demanded_in_place_take_a_finer_grid_and_keep_it) {
  const Plan loose = plan(smooth_spec(), {1.0 / 255, 0.25});
  const ToleranceResult& r = loose.chosen.result;
  const double between = (1 + r.share(r.met_in_place())) / 2;  // more than that has, less than all
  const Plan strict = plan(smooth_spec(), {1.0 / 255, 0.25, between});
  ASSERT_TRUE(strict.met);
  const ToleranceResult& s = strict.chosen.result;
  EXPECT_GE(s.share(s.met_in_place()), between);
  EXPECT_LT(r.share(r.met_in_place()), between);
  EXPECT_GT(strict.chosen.method.segments * strict.chosen.method.sides,
            loose.chosen.method.segments * loose.chosen.method.sides);
  EXPECT_THAT(plan_text(strict), HasSubstr("in place were demanded"));
}

TEST_F(Plans, that_lack_pixels_in_place_say_how_many_and_why) {
  const Plan p = plan(smooth_spec(), {1.0 / 255, 0.25, 1});  // no edge is met in place
  EXPECT_FALSE(p.met);
  EXPECT_EQ(p.chosen.result.lacking, p.chosen.result.shifted);
  EXPECT_EQ(p.chosen.result.failing, 0);
  long long blamed = 0;
  for (const Attribution& b : p.blamed) blamed += b.pixels;
  EXPECT_EQ(blamed, p.chosen.result.shifted);
  EXPECT_THAT(plan_text(p), HasSubstr("can't be met: "));
  EXPECT_THAT(plan_text(p), HasSubstr("100 % in place are demanded"));
}

TEST_F(Plans, errors_by_part_stay_below_what_is_predicted) {
  SceneSpec spec = small_spec(64);
  spec.texture = Bricks{};
  const Plan p = plan(spec);
  for (const ErrorPart& part : p.parts) {
    if (!part.predicted) continue;
    EXPECT_LE(part.measured, *part.predicted) << part.name;
  }
  EXPECT_THAT(p.parts, Contains(Field(&ErrorPart::name, "place")));
}

TEST(Prediction, bounds_what_coarse_and_fine_grids_show) {
  for (const Model model : {Model::kPhong, Model::kBlinnPhong, Model::kMinnaert}) {
    SceneSpec spec = small_spec(64);
    spec.view.material.model = model;
    spec.view.material.parameters["darkness"] = 1.5;
    spec.view.material.parameters["shininess"] = 20;
    const Scene scene = made(spec);
    const Tolerance tolerance;
    const std::vector<Fragment> seen = seen_of(spec);
    const Predictor predictor(whole(scene), knot_of(spec), seen, tolerance);
    measure::MethodBench bench(scene, knot_of(spec), {});
    for (const ShadingFrequency rate : {ShadingFrequency::kPixel, ShadingFrequency::kVertex}) {
      for (const measure::GridSize grid : {measure::GridSize{48, 8}, {96, 12}, {384, 40}}) {
        const measure::Method method =
            measure::with_grid({.rate = rate, .filter = Filter::kBilinear}, grid);
        for (const ErrorPart& part : error_parts(method, knot_of(spec), predictor, bench)) {
          if (!part.predicted) continue;
          EXPECT_LE(part.measured, *part.predicted)
              << part.name << " " << measure::method_name(method);
        }
      }
    }
  }
}

TEST(Prediction, comes_down_with_the_grid_at_order_two) {
  const SceneSpec spec = small_spec(64);
  const Scene scene = made(spec);
  const Predictor predictor(whole(scene), knot_of(spec), seen_of(spec), {});
  const double coarse =
      predictor.of(measure::with_grid({.filter = Filter::kBilinear}, {400, 40})).place;
  const double fine =
      predictor.of(measure::with_grid({.filter = Filter::kBilinear}, {800, 80})).place;
  EXPECT_NEAR(coarse / fine, 4, 0.4);  // higher orders, and the snapping of corners
}

TEST_F(Plans, are_refused_without_an_exact_surface) {
  SceneSpec spec = small_spec(16);
  std::get<KnotSpec>(spec.mesh).convention = Convention::kThree;
  std::get<KnotSpec>(spec.mesh).frames = FrameRule::kThree;
  EXPECT_THROW(plan(spec), Error);
  PlanJob job{made(small_spec(16)), small_spec(16), {}, false, 1};
  job.spec.mesh = MeshFile{"knot.obj"};
  EXPECT_THROW(check_plan(job), Error);
}

TEST(Ladder, rises_and_holds_the_scene_s_own_grid) {
  const SceneSpec spec = small_spec(64);
  const Predictor predictor(whole(made(spec)), knot_of(spec), seen_of(spec), {});
  const std::vector<measure::GridSize> ladder = grid_ladder(knot_of(spec), predictor);
  EXPECT_THAT(ladder, Contains(measure::GridSize{192, 16}));
  EXPECT_EQ(ladder.front().sides, 3);
  for (std::size_t i = 1; i < ladder.size(); ++i) {
    EXPECT_GE(ladder[i].segments * ladder[i].sides, ladder[i - 1].segments * ladder[i - 1].sides);
  }
}

}  // namespace
}  // namespace lumaknot::plan
