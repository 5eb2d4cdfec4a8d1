// Cycles with random samples: agrees as it is, and differs where a fault is planted.
#include "validate/noise.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/validate/small_scene.h"
#include "validate/compare/noise_words.h"
#include "validate/renderers/cycles_filter.h"
#include "validate/report/forms.h"

namespace lumaknot::validate {
namespace {

const RendererEntry& cycles() { return renderer_entry("Cycles"); }

using Fault = void (*)(Scene&, Material&);
Fault planted = nullptr;  // what FaultyCycles does to the scene and to the material of each shot

/// Cycles, handed something else.
class FaultyCycles final : public Renderer {
 public:
  explicit FaultyCycles(std::unique_ptr<Renderer> cycles) : cycles_(std::move(cycles)) {}
  std::string name() const override { return cycles_->name(); }
  Availability availability() const override { return cycles_->availability(); }
  Rendering draw(const Scene& scene, std::span<const Shot> shots) const override {
    Scene other = scene;
    std::vector<Shot> others(shots.begin(), shots.end());
    for (Shot& shot : others) {
      other = scene;
      planted(other, shot.material);
    }
    return cycles_->draw(other, others);
  }

 private:
  std::unique_ptr<Renderer> cycles_;
};

std::unique_ptr<Renderer> make_faulty(const Programs& programs, const Sampling& sampling) {
  return std::make_unique<FaultyCycles>(cycles().sampling->make(programs, sampling));
}

/// The bricks in 16 x 16 texels: a texel is larger than a pixel.
Texture coarse_bricks() {
  const TextureImage fine = bricks();
  TextureImage coarse(16, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x)
      coarse.at(x, y) = fine.at(fine.width * x / 16, fine.height * y / 16);
  }
  return coarse;
}

ValidationJob small_job() {
  ValidationJob job{testing::small_scene(64), {testing::final_shot("phong")}, {}, {}};
  job.scene.texture = coarse_bricks();
  return job;
}

Validation with_fault(Fault fault, int samples) {
  planted = fault;
  SamplingEntry sampling = *cycles().sampling;
  sampling.make = make_faulty;
  RendererEntry entry = cycles();
  entry.sampling = &sampling;
  return validate_noise(small_job(), entry, {samples, 0});
}

std::string told(const Validation& v) { return noise_summary(v, v.results.front()); }

TEST(CyclesFilter, has_an_integral_of_1_and_a_mean_of_a_two_thousandth_of_a_pixel) {
  double sum = 0, mean = 0;
  constexpr double kStep = 1.0 / 4096;
  for (double x = -2 + kStep / 2; x < 2; x += kStep) {
    sum += cycles_filter(x) * kStep;
    mean += x * cycles_filter(x) * kStep;
  }
  EXPECT_NEAR(sum, 1, 1e-4);
  EXPECT_NEAR(mean, 1.0 / 2046, 1e-5);
}

TEST(CyclesNoise, agrees_at_few_and_at_many_samples) {
  for (const int samples : {4, 32}) {
    const Validation v = validate_noise(small_job(), cycles(), {samples, 0});
    EXPECT_EQ(v.verdict, Verdict::kAgreed) << samples << " samples: " << told(v);
    ASSERT_EQ(v.results.size(), 1u);
    EXPECT_TRUE(v.results[0].drew_any()) << v.results[0].rendering.log;
    const NoiseTest& test = v.results[0].shots.back().noise;
    EXPECT_GT(test.scales.front().noise, 0) << "the seeds make two pictures";
    EXPECT_LT(test.scales.back().seen, 0.1 * test.scales.front().seen)
        << "the picture as a whole shows less than a pixel does";
    EXPECT_THAT(told(v), ::testing::HasSubstr("within its noise"));
  }
}

TEST(CyclesNoise, shows_a_light_that_is_moved) {
  const Validation v = with_fault(
      [](Scene& scene, Material&) {
        std::get<PointLight>(scene.view.lights.front()).position.x += 0.2;
      },
      32);
  EXPECT_EQ(v.verdict, Verdict::kDiffered) << told(v);
  EXPECT_EQ(v.results[0].first_difference, "diffuse") << "the texture does not see it";
  EXPECT_THAT(told(v), ::testing::HasSubstr("beyond its noise"));
}

TEST(CyclesNoise, shows_another_exponent) {
  const Validation v =
      with_fault([](Scene&, Material& material) { material.parameters["shininess"] *= 0.7; }, 32);
  EXPECT_EQ(v.verdict, Verdict::kDiffered) << told(v);
  EXPECT_EQ(v.results[0].first_difference, "specular");
}

TEST(CyclesNoise, shows_another_texture_filter) {
  const Validation v = with_fault(
      [](Scene& scene, Material&) {  // texels of four times the size that are not blended
        const TextureImage texture = std::get<TextureImage>(scene.texture);
        TextureImage blocks(texture.width * 4, texture.height * 4);
        for (int y = 0; y < blocks.height; ++y) {
          for (int x = 0; x < blocks.width; ++x) blocks.at(x, y) = texture.at(x / 4, y / 4);
        }
        scene.texture = blocks;
      },
      32);
  EXPECT_EQ(v.verdict, Verdict::kDiffered) << told(v);
  EXPECT_EQ(v.results[0].first_difference, "texture");
}

}  // namespace
}  // namespace lumaknot::validate
