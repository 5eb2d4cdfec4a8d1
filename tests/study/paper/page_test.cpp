#include <nlohmann/json.hpp>

#include "meshgen/knot_mesh.h"
#include "scene/presets.h"
#include "study/paper/checkpoint.h"
#include "study/paper/formula_claims.h"
#include "study/paper/reproduction.h"
#include "system/atomic_file.h"
#include "system/process.h"
#include "tests/study/paper/testing.h"

namespace lumaknot::paper {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

FigureImage drawn_image(const std::string& renderer, const std::string& picture) {
  return {.renderer = renderer,
          .file = figure_file(picture, renderer),
          .png = "bytes of " + picture,
          .outcome = renderer == "lumaknot" ? "" : "agreed",
          .why = {},
          .note = "composed",
          .mean = 1e-5,
          .agree = 0.5};
}

FigureImage absent_image(const std::string& renderer) {
  return {.renderer = renderer,
          .file = {},
          .png = {},
          .outcome = "skipped",
          .why = "apt-get install it",
          .note = {}};
}

/// Pictures by us and `other`.
LightPictures light(const std::vector<std::string>& names, bool other_drew) {
  LightPictures all;
  for (const std::string& name : names) {
    all.pictures.push_back({name,
                            {},
                            {drawn_image("lumaknot", name),
                             other_drew ? drawn_image("Other", name) : absent_image("Other")}});
  }
  all.renderers.push_back({.name = "Other",
                           .version = other_drew ? "Other 1.0" : "",
                           .seconds = 1.5,
                           .missing = other_drew ? "" : "apt-get install it"});
  return all;
}

LightPictures front(bool other_drew) {
  return light({"front-phong", "front-yiq", "front-table1", "specular-phong", "specular-yiq"},
               other_drew);
}

PaperResult result(bool other_drew) {
  PaperResult r;
  r.side = 64;
  r.figures = figures_of(front(other_drew), light({"back-phong", "back-yiq"}, other_drew));
  r.claims = {{"one", 1, "says <one>", "how", {at_most("number", 1234.5, 1)}, ""},
              {"two", 4, "says two", "how", {note("beside", 2)}, "only people can say"}};
  r.rates.width = r.rates.height = 64;
  r.rates.missing = {{"GPU", "no driver"}};
  return r;
}

TEST(PaperPage, shows_each_claim_with_its_numbers_bounds_and_verdict) {
  const std::string page = paper_html(result(true));
  for (const char* part : {"says &lt;one&gt;", "1,235", "at most 1", "does not hold",
                           "only people can say", "not measurable here", "5. Performance"}) {
    EXPECT_THAT(page, HasSubstr(part));
  }
}

TEST(PaperPage, needs_no_other_file_and_no_script) {
  const std::string page = paper_html(result(true));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
  for (const char* part : {"src=\"images", "http://", "https://", "<script", "<link"}) {
    EXPECT_THAT(page, Not(HasSubstr(part)));
  }
}

TEST(PaperPage, a_missing_renderer_is_named_with_the_remedy_and_has_no_pictures) {
  const std::string page = paper_html(result(false));
  EXPECT_THAT(page, HasSubstr("Other: missing, its pictures are absent: apt-get install it"));
  EXPECT_THAT(page, Not(HasSubstr("-other.png")));
  EXPECT_THAT(paper_text(result(false)), HasSubstr("Other is missing: apt-get install it"));
  EXPECT_THAT(paper_html(result(true)), Not(HasSubstr("missing, its pictures")));
}

TEST(PaperPage, json_holds_the_verdicts_of_its_own_numbers) {
  const auto json = nlohmann::json::parse(paper_json(result(true)));
  EXPECT_EQ(json["claims"].size(), 2u);
  EXPECT_EQ(json["claims"][0]["verdict"], "does not hold");
  EXPECT_EQ(json["claims"][0]["measures"][0]["meets"], false);
  EXPECT_EQ(json["figure1"].size(), 6u);
  EXPECT_EQ(json["figure2"].size(), 3u);
  EXPECT_EQ(json["table2"]["missing"][0]["renderer"], "GPU");
}

TEST(KeptLight, is_read_as_it_was_kept) {
  const PrivateFolder folder;
  keep_light(front(true), folder.path(), FigureLight::kFront, "key");
  const auto kept = kept_light(folder.path(), FigureLight::kFront, "key");
  ASSERT_TRUE(kept);
  const FigureImage was = front(true).pictures[4].images[1], is = kept->pictures[4].images[1];
  EXPECT_EQ(is.png, was.png);
  EXPECT_EQ(is.outcome, was.outcome);
  EXPECT_EQ(is.note, was.note);
  EXPECT_EQ(is.mean, was.mean);
  EXPECT_EQ(is.agree, was.agree);
  EXPECT_EQ(kept->renderers[0].version, "Other 1.0");
  EXPECT_EQ(checkpointed_lights(folder.path(), "key"), 1);
  EXPECT_EQ(checkpointed_lights(folder.path(), "other"), 0);
}

TEST(KeptLight, what_an_earlier_run_drew_and_this_one_did_not_goes_away) {
  const PrivateFolder folder;
  const std::filesystem::path file = folder.path() / figure_file("front-yiq", "Other");
  std::filesystem::create_directories(folder.path() / "images");
  write_file(file, "old", "test");
  keep_light(front(false), folder.path(), FigureLight::kFront, "key");
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(KeptLight, is_drawn_again_with_another_key_or_when_a_file_or_a_renderer_was_missing) {
  const PrivateFolder folder;
  const auto is_kept = [&](const std::string& key) {
    return kept_light(folder.path(), FigureLight::kBack, key).has_value();
  };
  EXPECT_FALSE(is_kept("key"));
  keep_light(light({"back-phong", "back-yiq"}, true), folder.path(), FigureLight::kBack, "key");
  EXPECT_TRUE(is_kept("key"));
  EXPECT_FALSE(is_kept("other"));
  std::filesystem::remove(folder.path() / "images/back-yiq-other.png");
  EXPECT_FALSE(is_kept("key"));
  keep_light(light({"back-phong", "back-yiq"}, false), folder.path(), FigureLight::kBack, "key");
  EXPECT_FALSE(is_kept("key"));
  write_file(folder.path() / "images/back.json", "{\"key\": \"key\"", "test");
  EXPECT_FALSE(is_kept("key"));
  forget_lights(folder.path());
  EXPECT_EQ(checkpointed_lights(folder.path(), "key"), 0);
}

/// The front and specular scenes on a small mesh in a small picture.
PaperScenes small_scenes() {
  PaperScenes scenes;
  KnotSpec knot;
  knot.segments = 48;
  knot.sides = 8;
  for (auto [name, scene] :
       {std::pair("figure1-front", &scenes.front), std::pair("figure1-back", &scenes.back),
        std::pair("figure1-specular", &scenes.specular)}) {
    *scene = {knot_mesh(knot), Vec3d{0.6, 0.3, 0.2}, builtin_scene(name)->view};
    scene->view.image = {32, 32, 1};
  }
  scenes.fragments = visible_fragments(scenes.front);
  return scenes;
}

TEST(PaperScenes, specular_only_is_drawn_in_the_front_scene_as_in_its_own) {
  const PaperScenes scenes = small_scenes();
  for (const char* formula : {"phong", "yiq-eq6", "yiq-table1"}) {
    const Material moved = *with_formula(transferred(scenes.specular, scenes.front), formula);
    const Image there = picture(scenes, scenes.front, moved);
    const Image own = picture(scenes, scenes.specular, formula_of(scenes.specular, formula));
    EXPECT_EQ(unlimited_change(there, own).max, 0) << formula;
  }
}

TEST(PaperScenes, the_claims_of_the_formulas_have_numbers_and_names_of_their_own) {
  const std::vector<PaperClaim> claims = formula_claims(small_scenes());
  std::vector<std::string> names;
  for (const PaperClaim& claim : claims) {
    EXPECT_FALSE(claim.measures.empty()) << claim.name;
    names.push_back(claim.name);
  }
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

}  // namespace
}  // namespace lumaknot::paper
