#include "diagnosis/diagnose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/diagnosis/small_case.h"

namespace lumaknot::diagnosis {
namespace {

using ::testing::HasSubstr;
using testing::own_picture;
using testing::small_case;
using testing::small_knot;
using Verdict = Diagnosis::Verdict;

Diagnosis diagnosis_of(const Scene& scene, const Image& theirs) {
  const Shot shot{"final", Stage::kFinal, scene.view.material};
  return diagnose({scene, shot, theirs, small_knot(), false, true});
}

/// `change` applied to each channel of the covered pixels.
template <class F>
Image changed(Image image, F change) {
  for (RgbaPixel& p : image.pixels) {
    if (p.coverage == 0) continue;
    for (float* v : {&p.color.r, &p.color.g, &p.color.b}) *v = float(change(double(*v)));
  }
  return image;
}

Image in_eight_bits(const Image& image) {
  return changed(image, [](double v) { return std::round(std::clamp(v, 0.0, 1.0) * 255) / 255; });
}

std::vector<std::string> ids(const Diagnosis& d) {
  std::vector<std::string> all;
  for (const NamedCause& cause : d.cause.causes) all.push_back(cause.id);
  return all;
}

double value_of(const Diagnosis& d, std::size_t cause, const std::string& name) {
  for (const NamedNumber& n : d.cause.causes.at(cause).numbers) {
    if (n.name == name) return n.value;
  }
  return std::nan("");
}

TEST(Diagnose, accuses_nothing_of_our_own_picture) {
  const Scene scene = small_case();
  EXPECT_EQ(diagnosis_of(scene, own_picture(scene)).verdict, Verdict::kAgrees);
}

TEST(Diagnose, accuses_nothing_of_eight_bits) {
  const Scene scene = small_case();
  EXPECT_EQ(diagnosis_of(scene, in_eight_bits(own_picture(scene))).verdict, Verdict::kAgrees);
}

TEST(Diagnose, names_gamma_with_its_value) {
  const Scene scene = small_case();
  const Image theirs =
      changed(own_picture(scene), [](double v) { return std::pow(std::max(v, 0.0), 1 / 2.2); });
  const Diagnosis d = diagnosis_of(scene, theirs);
  ASSERT_EQ(d.verdict, Verdict::kNamed);
  EXPECT_THAT(ids(d), ::testing::ElementsAre("gamma"));
  EXPECT_NEAR(value_of(d, 0, "gamma"), 2.2, 1e-5);
  EXPECT_THAT(sentence_of(d), HasSubstr("gamma 2.2"));
}

TEST(Diagnose, finds_where_a_picture_was_cut_out) {
  const Scene scene = small_case();
  const Image own = own_picture(scene);
  Image theirs(70, 50);
  for (int y = 0; y < theirs.height; ++y) {
    for (int x = 0; x < theirs.width; ++x) theirs.at(x, y) = own.at(x + 17, y + 5);
  }
  const Diagnosis d = diagnosis_of(scene, theirs);
  ASSERT_EQ(d.verdict, Verdict::kNamed);
  EXPECT_THAT(ids(d), ::testing::ElementsAre("size-cut"));
  EXPECT_NEAR(value_of(d, 0, "left"), 17, 1e-3);
  EXPECT_NEAR(value_of(d, 0, "top"), 5, 1e-3);
}

TEST(Diagnose, names_a_tone_curve) {
  const Scene scene = small_case();
  Image theirs = own_picture(scene);
  for (RgbaPixel& p : theirs.pixels) p.color = to_rgb(toned(Tone::kAgx, to_vec(p.color)));
  const Diagnosis d = diagnosis_of(scene, theirs);
  ASSERT_EQ(d.verdict, Verdict::kNamed);
  EXPECT_THAT(ids(d), ::testing::ElementsAre("tone-agx"));
}

TEST(Diagnose, finds_a_tone_curve_that_has_no_name) {
  const Scene scene = small_case();
  const Diagnosis d = diagnosis_of(scene, changed(own_picture(scene), [](double v) {
                                     return std::tanh(1.3 * v) + 0.05 * std::sin(3 * v);
                                   }));
  ASSERT_EQ(d.verdict, Verdict::kNamed);
  EXPECT_THAT(ids(d), ::testing::ElementsAre("tone-curve"));
  EXPECT_THAT(sentence_of(d), HasSubstr("makes 0.18"));
}

TEST(Diagnose, names_noise_with_its_deviation) {
  const Scene scene = small_case();
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 0.04);
  const Diagnosis d = diagnosis_of(
      scene, changed(own_picture(scene), [&](double v) { return v + normal(random); }));
  ASSERT_EQ(d.verdict, Verdict::kNamed);
  EXPECT_THAT(ids(d), ::testing::ElementsAre("noise"));
  EXPECT_NEAR(value_of(d, 0, "deviation"), 0.04, 2e-3);  // of some 5,000 values
}

TEST(Diagnose, names_gamma_in_eight_bits) {
  const Scene scene = small_case();
  const Image theirs = in_eight_bits(
      changed(own_picture(scene), [](double v) { return std::pow(std::max(v, 0.0), 1 / 2.2); }));
  const Diagnosis d = diagnosis_of(scene, theirs);
  ASSERT_EQ(d.verdict, Verdict::kNamed);
  EXPECT_THAT(ids(d), ::testing::ElementsAre("gamma"));
  EXPECT_NEAR(value_of(d, 0, "gamma"), 2.2, 1e-3);  // thousands of pixels rounded to 1/255
}

TEST(Diagnose, names_a_moved_lamp_with_its_place) {
  const Scene scene = small_case();
  Scene moved = scene;
  std::get<PointLight>(moved.view.lights.front()).position = {-1.5, -3.0, 3.2};
  const Diagnosis d = diagnosis_of(scene, own_picture(moved));
  ASSERT_EQ(d.verdict, Verdict::kNamed);
  EXPECT_THAT(ids(d), ::testing::ElementsAre("light-position"));
  EXPECT_NEAR(value_of(d, 0, "z"), 3.2, 1e-4);
}

TEST(Diagnose, names_a_field_of_view) {
  const Scene scene = small_case();
  Scene wider = scene;
  wider.view.camera.fov_degrees *= 1.02;
  const Diagnosis d = diagnosis_of(scene, own_picture(wider));
  ASSERT_EQ(d.verdict, Verdict::kNamed);
  EXPECT_THAT(ids(d), ::testing::ElementsAre("fov"));
  EXPECT_NEAR(value_of(d, 0, "fov_degrees"), 45.9, 1e-3);
}

TEST(Diagnose, names_both_of_two_causes) {
  const Scene scene = small_case();
  Scene other = scene;
  other.view.ambient = 0.3;
  const Image theirs =
      changed(own_picture(other), [](double v) { return std::pow(std::max(v, 0.0), 1 / 1.8); });
  const Diagnosis d = diagnosis_of(scene, theirs);
  ASSERT_EQ(d.verdict, Verdict::kNamed);
  EXPECT_THAT(ids(d), ::testing::ElementsAre("ambient", "gamma"));
  EXPECT_NEAR(value_of(d, 0, "ambient"), 0.3, 1e-3);
  EXPECT_NEAR(value_of(d, 1, "gamma"), 1.8, 1e-3);
}

TEST(Diagnose, says_unknown_of_a_vignette) {
  const Scene scene = small_case();
  Image theirs = own_picture(scene);
  for (int y = 0; y < theirs.height; ++y) {
    for (int x = 0; x < theirs.width; ++x) {
      const double r = std::hypot(x - 48.0, y - 36.0) / 60;
      Rgb& c = theirs.at(x, y).color;
      c = to_rgb(to_vec(c) * (1 - 0.5 * r * r));
    }
  }
  const Diagnosis d = diagnosis_of(scene, theirs);
  EXPECT_EQ(d.verdict, Verdict::kUnknown);
  EXPECT_THAT(sentence_of(d), HasSubstr("unknown; nearest: "));
}

TEST(Diagnose, names_alpha_that_is_one_everywhere) {
  const Scene scene = small_case();
  Image theirs = own_picture(scene);
  for (RgbaPixel& p : theirs.pixels) p.coverage = 1;
  const Diagnosis d = diagnosis_of(scene, theirs);
  ASSERT_EQ(d.verdict, Verdict::kNamed);
  EXPECT_THAT(ids(d), ::testing::ElementsAre("alpha-opaque"));
}

}  // namespace
}  // namespace lumaknot::diagnosis
