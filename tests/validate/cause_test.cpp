#include "validate/cause.h"

#include <gtest/gtest.h>

namespace lumaknot::validate {
namespace {

using diagnosis::Diagnosis;
using diagnosis::Explained;
using diagnosis::Rung;

Explained explained(const std::vector<std::pair<std::string, Rung>>& causes) {
  Explained result;
  for (const auto& [id, rung] : causes) result.causes.push_back({id, id, {}, rung});
  return result;
}

Diagnosis named(Explained cause, std::vector<Explained> equivalents = {}) {
  Diagnosis d;
  d.verdict = Diagnosis::Verdict::kNamed;
  d.cause = std::move(cause);
  d.equivalents = std::move(equivalents);
  return d;
}

const Explained kLamp = explained({{"light-intensity", Rung::kLight}});
const Explained kExposure = explained({{"exposure", Rung::kEncoding}});

TEST(PreferByRung, blames_no_lamp_for_a_texture_without_light) {
  Diagnosis d = named(kLamp, {kExposure});
  prefer_by_rung(d, FirstDifference::kTexture);
  EXPECT_EQ(d.cause.causes.front().id, "exposure");
  EXPECT_EQ(d.equivalents.front().causes.front().id, "light-intensity");
}

TEST(PreferByRung, blames_no_encoding_where_the_texture_agrees) {
  Diagnosis d = named(kExposure, {kLamp});
  prefer_by_rung(d, FirstDifference::kLight);
  EXPECT_EQ(d.cause.causes.front().id, "light-intensity");
}

TEST(PreferByRung, keeps_what_nothing_else_explains) {
  Diagnosis d = named(kLamp);
  prefer_by_rung(d, FirstDifference::kTexture);
  EXPECT_EQ(d.cause.causes.front().id, "light-intensity");
}

TEST(RungOf, is_placement_whatever_else_differs) {
  const Diagnosis d = named(explained({{"fov", Rung::kPlacement}, {"gamma", Rung::kEncoding}}));
  EXPECT_EQ(rung_of(d, FirstDifference::kCoverage), "placement");
  EXPECT_EQ(rung_of(d, FirstDifference::kTexture), "placement");
}

TEST(RungOf, is_encoding_only_if_the_texture_differs_too) {
  EXPECT_EQ(rung_of(named(kExposure), FirstDifference::kTexture), "encoding");
  EXPECT_EQ(rung_of(named(kExposure), FirstDifference::kLight), "");
}

TEST(RungOf, is_nothing_of_an_unknown_cause) {
  Diagnosis d = named(kExposure);
  d.verdict = Diagnosis::Verdict::kUnknown;
  EXPECT_EQ(rung_of(d, FirstDifference::kTexture), "");
}

}  // namespace
}  // namespace lumaknot::validate
