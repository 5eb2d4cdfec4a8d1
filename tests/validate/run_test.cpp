// The whole job with misbehaving programs in place of the renderers.
#include "validate/run.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "exporters/image/file.h"
#include "system/process.h"
#include "tests/validate/small_scene.h"
#include "validate/renderers/entry.h"
#include "validate/renderers/external.h"
#include "validate/report/forms.h"

namespace lumaknot::validate {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

fs::path script(const PrivateFolder& folder, const std::string& name, const std::string& body) {
  const fs::path path = folder.path() / name;
  std::ofstream(path) << "#!/bin/sh\n" << body << "\n";
  fs::permissions(path, fs::perms::owner_all);
  return path;
}

Validation validate_with(const std::string& povray, std::vector<std::string> renderers,
                         double limit = 20) {
  ValidationJob job{
      testing::small_scene(48), {testing::final_shot("phong")}, std::move(renderers), {}};
  for (const ProgramInfo* program : renderer_programs()) {
    job.programs.paths[program->flag] = "/nonexistent/program";
  }
  job.programs.paths[kPovrayProgram.flag] = povray;
  job.programs.time_limit = std::chrono::duration<double>(limit);
  return validate(job);
}

TEST(RendererEntries, make_the_renderers_of_their_names) {
  std::set<std::string_view> flags;
  for (const RendererEntry* entry : renderer_entries()) {
    EXPECT_EQ(entry->make({})->name(), entry->name) << "limits are found by this name";
    EXPECT_FALSE(entry->promise.reason.empty()) << entry->name;
    EXPECT_TRUE(flags.insert(entry->flag).second) << entry->flag;
  }
}

TEST(Validate, without_any_renderer_there_is_nothing_to_compare) {
  const Validation v = validate_with("/nonexistent/povray", {});
  EXPECT_EQ(v.verdict, Verdict::kNothingToCompare);
  ASSERT_EQ(v.results.size(), 5u) << "cycles, povray, eevee, gl, vulkan";
  for (const RendererResult& result : v.results) {
    for (const Judged& shot : result.shots) {
      EXPECT_EQ(shot.drawn.status, RenderedShot::Status::kSkipped);
      EXPECT_THAT(shot.drawn.why, HasSubstr(" not found; ")) << "the reason and the remedy";
    }
  }
}

TEST(Validate, does_not_believe_a_program_that_ends_well_and_draws_nothing) {
  const PrivateFolder folder;
  const Validation v = validate_with(script(folder, "povray", "exit 0"), {"povray"});
  EXPECT_EQ(v.verdict, Verdict::kDiffered);
  EXPECT_EQ(v.results.at(0).shots.at(0).drawn.status, RenderedShot::Status::kFailed);
}

TEST(Validate, tells_the_last_line_of_a_program_that_fails) {
  const PrivateFolder folder;
  const Validation v = validate_with(
      script(folder, "povray", "echo first; echo 'out of wool' >&2; exit 4"), {"povray"});
  EXPECT_EQ(v.verdict, Verdict::kDiffered);
  EXPECT_THAT(v.results.at(0).shots.at(0).drawn.why, HasSubstr("exit code 4: out of wool"));
}

TEST(Validate, kills_a_program_that_does_not_end) {
  const PrivateFolder folder;
  const Validation v = validate_with(script(folder, "povray", "sleep 600"), {"povray"}, 0.3);
  EXPECT_EQ(v.verdict, Verdict::kDiffered);
  EXPECT_THAT(v.results.at(0).shots.at(0).drawn.why, HasSubstr("time limit"));
}

TEST(DrawnImage, is_believed_only_when_it_decodes_fits_and_shows_something) {
  const PrivateFolder folder;
  View view;
  view.image = {8, 6, 1};
  const auto why = [&](const Image& image) {
    write_image(folder.path() / "image.exr", image, "test");
    return drawn_image(folder.path() / "image.exr", view).why;
  };
  Image good(8, 6);
  good.at(3, 3) = {{0, 0, 0}, 1};
  EXPECT_EQ(why(good), "");
  EXPECT_THAT(why(Image(8, 6)), HasSubstr("blank"));
  EXPECT_THAT(why(Image(6, 8)), HasSubstr("6 x 8"));
  Image broken = good;
  broken.at(0, 0).color.g = NAN;
  EXPECT_THAT(why(broken), HasSubstr("not finite"));
  EXPECT_NE(drawn_image(folder.path() / "missing.exr", view).why, "");
  std::ofstream(folder.path() / "garbage.exr") << "no image";
  EXPECT_NE(drawn_image(folder.path() / "garbage.exr", view).why, "");
}

TEST(SampleBySample, makes_each_sample_a_pixel) {
  Scene scene = testing::small_scene(10);
  scene.view.image.samples = 3;
  const ImageSpec image = sample_by_sample(scene).view.image;
  EXPECT_EQ(image.width, 30);
  EXPECT_EQ(image.height, 30);
  EXPECT_EQ(image.samples, 1);
}

TEST(Report, json_holds_the_outcome_of_every_shot) {
  const Validation v = validate_with("/nonexistent/povray", {});
  const auto json = nlohmann::json::parse(report_json(v, {"scene", "command"}));
  EXPECT_EQ(json["verdict"], "nothing to compare");
  ASSERT_EQ(json["renderers"].size(), 5u);
  for (const auto& renderer : json["renderers"]) {
    EXPECT_EQ(renderer["coverage"]["outcome"], "skipped");
    ASSERT_EQ(renderer["shots"].size(), 4u);
    for (const auto& shot : renderer["shots"]) EXPECT_EQ(shot["outcome"], "skipped");
  }
  EXPECT_TRUE(json["own"]["claims"].contains("phong"));
}

TEST(Report, page_needs_nothing_else_and_trusts_no_name) {
  const Validation v = validate_with("/nonexistent/povray", {"povray"});
  const std::string page = report_html(v, {"<script>alert(1)</script>", "command"});
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, HasSubstr("script-src 'sha256-")) << "no script but its own runs";
  EXPECT_THAT(page, Not(HasSubstr("http:")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  EXPECT_THAT(page, HasSubstr("skipped"));
  EXPECT_THAT(page, Not(HasSubstr("{{"))) << "every tag of the template is filled";
}

}  // namespace
}  // namespace lumaknot::validate
