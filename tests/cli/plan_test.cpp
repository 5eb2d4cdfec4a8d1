// lumaknot plan, run as a program. No test depends on timings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

class PlanCommand : public Program {
 protected:
  void SetUp() override { write("small.json", kSmall); }

  static constexpr const char* kSmall =
      R"({"mesh": {"knot": {"segments": 96, "sides": 10}}, "texture": {"color": [0.8, 0.3, 0.2]},
          "image": {"width": 32, "height": 24}})";

  static std::vector<std::string> quick(const std::vector<std::string>& more = {}) {
    std::vector<std::string> all{"plan", "small.json", "--rounds", "1", "-o", "out"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  nlohmann::json certificate() { return nlohmann::json::parse(read("out/certificate.json")); }

  std::vector<std::string> written() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path("out"))) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }
};

TEST_F(PlanCommand, writes_the_smaller_scene_its_certificate_and_the_page) {
  const ProcessResult result = lumaknot(quick());
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_TRUE(result.log.starts_with("met")) << result.log;
  EXPECT_THAT(result.log, HasSubstr("of the pixels in place"));
  EXPECT_THAT(result.log, HasSubstr("draw it: lumaknot render out/scene.json"));
  EXPECT_THAT(written(), IsSupersetOf({"scene.json", "certificate.json", "index.html"}));
  EXPECT_EQ(certificate()["met"], true);
  EXPECT_LE(certificate()["chosen"]["measured"]["error"], 1.0 / 255);
  EXPECT_THAT(read("out/index.html"), Not(HasSubstr("src=\"http")));
}

TEST_F(PlanCommand, writes_a_scene_that_the_reported_command_draws) {
  const std::string planned = lumaknot(quick()).log;
  std::vector<std::string> arguments{"render", "out/scene.json"};
  // Which words these are depends on what was measured to be fast: with sanitizers, often none.
  const nlohmann::json words = certificate()["render_arguments"];
  for (const auto& word : words) arguments.push_back(word);
  arguments.insert(arguments.end(), {"-o", "planned.png"});
  EXPECT_THAT(planned, HasSubstr(fmt::format("draw it: lumaknot {}\n", fmt::join(arguments, " "))));
  const ProcessResult result = lumaknot(arguments);
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_GT(fs::file_size(path("planned.png")), 500u);
}

TEST_F(PlanCommand, copies_the_texture) {
  lumaknot({"render", "figure2", "-o", "wall.png"});
  fs::create_directory(path("below"));
  fs::rename(path("wall.png"), path("below/wall.png"));
  write("below/scene.json",
        R"({"texture": {"file": "wall.png"}, "image": {"width": 32, "height": 24}})");
  const ProcessResult result =
      lumaknot({"plan", "below/scene.json", "--tolerance", "0.2", "--rounds", "1", "-o", "out"});
  EXPECT_THAT(result, ExitsWith(0));
  EXPECT_EQ(read("out/texture.png"), read("below/wall.png"));
  EXPECT_EQ(nlohmann::json::parse(read("out/scene.json"))["texture"]["file"], "texture.png");
}

TEST_F(PlanCommand, never_overwrites_its_own_scene_and_texture) {
  fs::create_directory(path("own"));
  lumaknot({"render", "figure2", "--fast", "-o", "own/texture.png"});
  write("own/scene.json",
        R"({"texture": {"file": "texture.png"}, "image": {"width": 32, "height": 24}})");
  const std::string scene = read("own/scene.json"), texture = read("own/texture.png");
  expect_refused({"plan", "own/scene.json", "-o", "own"}, "would overwrite the scene");
  fs::rename(path("own/scene.json"), path("own/mine.json"));
  expect_refused({"plan", "own/mine.json", "-o", "own"}, "would overwrite texture.file");
  fs::create_directory(path("links"));
  fs::create_symlink("../own/mine.json", path("links/certificate.json"));
  expect_refused({"plan", "own/mine.json", "-o", "links/."}, "would overwrite the scene");
  EXPECT_EQ(read("own/mine.json"), scene);
  EXPECT_EQ(read("own/texture.png"), texture);
  EXPECT_FALSE(fs::exists(path("own/measured.json")));
}

TEST_F(PlanCommand, may_run_again_in_its_own_folder) {
  lumaknot(quick());
  EXPECT_THAT(lumaknot(quick()), ExitsWith(0));
  expect_refused({"plan", "out/scene.json", "-o", "out"}, "would overwrite the scene");
}

TEST_F(PlanCommand, prints_only_json_on_request) {
  const ProcessResult result = lumaknot(quick({"--json"}));
  EXPECT_EQ(nlohmann::json::parse(result.log), certificate());
}

TEST_F(PlanCommand, reports_why_a_tolerance_cannot_be_met) {
  const ProcessResult result = lumaknot(quick({"--shift", "0"}));
  EXPECT_THAT(result, ExitsWith(1));
  EXPECT_THAT(result.log, HasSubstr("can't be met: "));
  EXPECT_THAT(result.log, HasSubstr("allow a --shift"));
  EXPECT_FALSE(certificate()["blame"].empty());
  EXPECT_EQ(certificate()["met"], false);
}

TEST_F(PlanCommand, a_share_in_place_is_demanded) {
  const ProcessResult all = lumaknot(quick({"--in-place", "100%"}));
  EXPECT_THAT(all, ExitsWith(1)) << "no edge is met in place";
  EXPECT_THAT(all.log, HasSubstr("can't be met: "));
  EXPECT_GT(certificate()["in_place"]["lacking_pixels"], 0);
  const double share = certificate()["in_place"]["share"];
  EXPECT_THAT(lumaknot(quick({"--in-place", std::to_string(share / 2)})), ExitsWith(0));
  EXPECT_EQ(certificate()["in_place"]["lacking_pixels"], 0);
}

TEST_F(PlanCommand, meaningless_shares_in_place_are_refused) {
  for (const char* wrong : {"99", "101%", "-1%", "-0.1", "1.01", "nan", "nan%", "inf", "%", "all",
                            "9 9%", "99%%", "99 %"}) {
    expect_refused(quick({std::string("--in-place=") + wrong}), "--in-place must be a share");
  }
  expect_refused(quick({"--in-place="}), "--in-place");
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(PlanCommand, leaves_out_what_no_pixel_needs) {
  write("small.json", R"({"mesh": {"knot": {"segments": 96, "sides": 10}},
    "texture": {"color": [0.8, 0.3, 0.2]}, "image": {"width": 32, "height": 24},
    "lights": [{"point": {}}, {"directional": {"intensity": 1e-4}}]})");
  lumaknot(quick());
  EXPECT_EQ(certificate()["dropped"][0]["what"], "light 2 left out");
  EXPECT_EQ(nlohmann::json::parse(read("out/scene.json"))["lights"].size(), 1u);
}

TEST_F(PlanCommand, ctrl_c_keeps_what_was_measured_and_the_same_command_resumes) {
  std::vector<std::string> arguments = quick({"--exhaustive"});
  arguments[3] = "1000";  // rounds
  arguments.insert(arguments.begin(), LUMAKNOT_PROGRAM);
  Process process({arguments, folder_.path(), sanitizer_options()});
  for (int tries = 0; tries < 1000 && !fs::exists(path("out/measured.json")); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  process.signal(SIGINT);
  const ProcessResult result = process.wait(std::chrono::seconds(30));
  EXPECT_THAT(result, ExitsWith(130));
  EXPECT_THAT(result.log,
              HasSubstr("choices are measured and kept in out; the same command resumes"));
  const auto kept = nlohmann::json::parse(read("out/measured.json"))["judgements"];
  EXPECT_FALSE(kept.empty());
  lumaknot(quick({"--quiet"}));
  const auto after = nlohmann::json::parse(read("out/measured.json"))["judgements"];
  for (const auto& [name, judgement] : kept.items()) EXPECT_EQ(after[name], judgement);
}

TEST_F(PlanCommand, ctrl_c_before_anything_is_measured_is_reported_and_keeps_no_folder) {
  write("large.json", R"({"image": {"width": 3000, "height": 2400}})");
  Process process(
      {{LUMAKNOT_PROGRAM, "plan", "large.json", "-o", "out"}, folder_.path(), sanitizer_options()});
  for (int tries = 0; tries < 1000 && !fs::exists(path("out")); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  process.signal(SIGINT);
  const ProcessResult result = process.wait(std::chrono::seconds(30));
  EXPECT_THAT(result, ExitsWith(130));
  EXPECT_THAT(result.log, HasSubstr("interrupted; nothing is kept yet"));
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(PlanCommand, another_tolerance_is_measured_again_and_reported) {
  lumaknot(quick());
  EXPECT_THAT(lumaknot(quick({"--tolerance", "0.02"})).log, HasSubstr("measured again"));
  EXPECT_EQ(certificate()["tolerance"]["color"], 0.02);
}

TEST_F(PlanCommand, meaningless_tolerances_are_refused) {
  for (const char* wrong : {"0", "-1/255", "nan", "inf", "1/0", "0/0", "one", "1/", "", "1/2/3"}) {
    expect_refused(quick({std::string("--tolerance=") + wrong}), "--tolerance");
  }
  for (const char* wrong : {"1", "5", "255/255", "255/1"}) {
    expect_refused(quick({"--tolerance", wrong}), "--tolerance must be > 0 and < 1");
  }
  for (const char* wrong : {"0/0", "-1/-255", "1/0", "1/-255"}) {
    expect_refused(quick({std::string("--tolerance=") + wrong}), std::string("got ") + wrong);
  }
  expect_refused(quick({"--tolerance", "1e-9"}), "finer than the truth");
  write("small.json", R"({"image": {"width": 32, "height": 24, "samples": 2}})");
  expect_refused(quick({"--tolerance", "5e-5"}), "finer than the truth");
  expect_refused(quick({"--shift", "-1"}), "--shift");
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(PlanCommand, scenes_without_a_pixel_or_an_exact_surface_are_refused) {
  write("nothing.json", R"({"camera": {"position": [0, -3, 0], "target": [0, -9, 0]},
                            "image": {"width": 24, "height": 20}})");
  for (const char* command : {"plan", "budget"}) {
    expect_refused({command, "nothing.json"}, "covers no pixel's centre; move camera.position");
  }
  expect_refused({"plan", "nothing.json", "-o", "new/out"}, "covers no pixel");
  EXPECT_THAT(files(), ElementsAre("nothing.json", "small.json")) << "no empty folder";
  fs::create_directories(path("old/out"));
  expect_refused({"plan", "nothing.json", "-o", "old/out"}, "covers no pixel");
  EXPECT_TRUE(fs::exists(path("old/out")));
  write("three.json", R"({"mesh": {"knot": {"convention": "three"}}})");
  expect_refused({"plan", "three.json", "-o", "out"}, "three");
  lumaknot({"mesh", "--segments", "24", "--sides", "6", "-o", "knot.obj"});
  write("file.json", R"({"mesh": {"file": "knot.obj"}, "image": {"width": 24, "height": 20}})");
  expect_refused({"plan", "file.json", "-o", "out"}, "a mesh file has no exact surface");
  write("file", "");
  expect_refused({"plan", "small.json", "-o", "file"}, "--output file");
  expect_refused(quick({"--rounds", "0"}), "--rounds");
}

}  // namespace
}  // namespace lumaknot::cli
