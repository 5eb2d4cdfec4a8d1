// The whole paper with Cycles, POV-Ray and llvmpipe, in small pictures. No time is expected.
#include <nlohmann/json.hpp>

#include "tests/cli/program_test.h"
#include "tests/system/exits_with.h"

namespace lumaknot {
namespace {

class WholePaper : public cli::Program {};

TEST_F(WholePaper, all_three_renderers_draw_every_picture_and_agree) {
  const ProcessResult ended = lumaknot(
      {"paper", "--size", "96", "--rounds", "1", "--seconds", "0.02", "-o", "out", "--quiet"});
  ASSERT_THAT(ended, ExitsWith(0));
  EXPECT_EQ(ended.log, "");
  const auto json = nlohmann::json::parse(read("out/claims.json"));
  for (const char* figure : {"figure1", "figure2"}) {
    for (const auto& picture : json[figure]) {
      ASSERT_EQ(picture["images"].size(), 3u) << picture["name"];
      for (const auto& image : picture["images"]) {
        EXPECT_TRUE(std::filesystem::exists(path("out") / image["file"].get<std::string>()))
            << image;
        EXPECT_EQ(image.value("outcome", "agreed"), "agreed") << image;  // ours has none
      }
    }
  }
  for (const auto& claim : json["claims"]) EXPECT_FALSE(claim["measures"].empty()) << claim["name"];
}

}  // namespace
}  // namespace lumaknot
