#include "models/registry.h"

#include <gmock/gmock.h>

namespace lumaknot {
namespace {

const Parameter& named(std::string_view name) {
  return *std::ranges::find(model_parameters(), name, &Parameter::name);
}

TEST(ModelParameters, are_those_of_all_terms_each_once) {
  std::vector<std::string_view> names;
  for (const Parameter& p : model_parameters()) names.push_back(p.name);
  EXPECT_THAT(names, ::testing::ElementsAre("shininess", "roughness", "reflectance", "darkness"));
}

TEST(ModelParameters, have_the_range_of_every_term) {
  EXPECT_EQ(named("roughness").range.min, OrenNayarDiffuse::kParameters[0].range.min);
  EXPECT_EQ(CookTorranceHighlight::kParameters[0].range.min, 0.04);
  EXPECT_EQ(named("shininess").range.max, std::numeric_limits<double>::max());
}

TEST(ModelParameters, name_the_models_that_differ_in_their_meaning) {
  EXPECT_EQ(named("shininess").meaning, "k of the highlight max(v.R, 0)^k");
  EXPECT_EQ(named("roughness").meaning,
            "oren-nayar: sigma, radians; cook-torrance: square root of alpha");
  EXPECT_EQ(named("darkness").meaning, "minnaert: 1 is Lambert");
}

TEST(ModelParameters, of_one_name_agree_on_all_but_range_and_meaning) {
  for_each_term([](auto term) {
    for (const Parameter& p : term.kParameters) {
      const Parameter& common = named(p.name);
      EXPECT_EQ(p.value, common.value) << p.name;
      EXPECT_EQ(p.unit, common.unit) << p.name;
      EXPECT_EQ(p.semantic, common.semantic) << p.name;
      EXPECT_EQ(p.step, common.step) << p.name;
      EXPECT_EQ(p.slider.min, common.slider.min) << p.name;
      EXPECT_EQ(p.slider.max, common.slider.max) << p.name;
    }
  });
}

TEST(ModelParameters, begin_with_the_defaults) {
  const ModelParameters<float> numbers;
  EXPECT_EQ(numbers["shininess"], 55.0f);
  EXPECT_EQ(numbers["roughness"], 0.3f);
  EXPECT_EQ(numbers.with("roughness", 0.5f)["roughness"], 0.5f);
  EXPECT_EQ(numbers.with("roughness", 0.5f)["shininess"], 55.0f);
}

TEST(Models, pass_their_terms_the_numbers_that_they_read) {
  const auto numbers = ModelParameters<double>().with("roughness", 0.5).with("reflectance", 0.1);
  const auto read = [&](Model model) {
    return with_highlight(model, numbers,
                          [](auto, auto... p) { return std::vector<double>{p...}; });
  };
  EXPECT_THAT(read(Model::kCookTorrance), ::testing::ElementsAre(0.5, 0.1));
  EXPECT_THAT(read(Model::kPhong), ::testing::ElementsAre(55));
}

TEST(Models, have_the_names_of_scenes) {
  EXPECT_EQ(kModelNames[std::size_t(Model::kOrenNayar)], "oren-nayar");
  EXPECT_EQ(with_model(Model::kOrenNayar, [](auto model) { return model.kName; }), "oren-nayar");
}

}  // namespace
}  // namespace lumaknot
