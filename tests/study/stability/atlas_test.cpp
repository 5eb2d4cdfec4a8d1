// How boundaries are found and reported.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "study/stability/atlas_report.h"
#include "study/stability/sketches.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "system/process.h"

namespace lumaknot::stability {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Holds up to x = `at`.
Region step_at(double at, const Sweep& sweep) {
  Region region;
  region.name = "step";
  region.group = "Steps";
  region.method = "a <step>";
  region.sweep = sweep;
  region.limit = 1;
  region.error = [at, rising = sweep.to > sweep.from](double x) {
    return (rising ? x <= at : x >= at) ? 0.5 : std::numeric_limits<double>::quiet_NaN();
  };
  region.guarded = [](double) { return 0.25; };
  return region;
}

Boundary boundary_of(const Region& region) {
  return examine(region, {.pictures = false}, [](double) {}).boundary;
}

TEST(Boundary, is_bisected_to_a_millionth_of_the_way) {
  const Boundary rising = boundary_of(step_at(0.3, {"x", 0, 2}));
  EXPECT_LE(rising.holds.x, 0.3);
  EXPECT_GT(rising.fails.x, 0.3);
  EXPECT_LE(rising.fails.x - rising.holds.x, 2e-6);
  const Boundary falling = boundary_of(step_at(1e-20, {"x", 1, 1e-30, true}));
  EXPECT_GE(falling.holds.x, 1e-20);
  EXPECT_LT(falling.fails.x, 1e-20);
  EXPECT_LE(std::log(falling.holds.x / falling.fails.x), 1e-6 * std::log(1e30) * 1.001);
}

TEST(Boundary, of_whole_numbers_is_between_neighbours) {
  for (const bool logarithmic : {false, true}) {
    for (const double at : {1.0, 2.0, 37.0, 99999.0}) {
      const Boundary found = boundary_of(step_at(at, {"n", 1, 1e5, logarithmic, true}));
      EXPECT_EQ(found.holds.x, at);
      EXPECT_EQ(found.fails.x, at + 1);
    }
  }
  EXPECT_EQ(boundary_of(step_at(7, {"n", 40, 3, true, true})).fails.x, 6);
}

TEST(Boundary, must_be_on_the_way) {
  EXPECT_THROW(boundary_of(step_at(3, {"x", 0, 2})), std::logic_error);
  EXPECT_THROW(boundary_of(step_at(-1, {"x", 0, 2})), std::logic_error);
}

/// Holds below 0.3, from 1 to 1.3 and at 2.
Region waves() {
  Region region = step_at(0.3, {"x", 0, 2});
  region.error = [](double x) { return x < 0.3 || (x > 0.99 && x < 1.31) || x == 2 ? 0.5 : 2; };
  return region;
}

TEST(Stretches, are_of_one_kind) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Measured> sweep{{5, 0}, {4, 1}, {3, none}, {2, 2}, {1, 1}, {0, 2}};
  const std::vector<SweepInterval> holding = stretches(sweep, 1, true),
                                   failing = stretches(sweep, 1, false);
  ASSERT_EQ(holding.size(), 2u);
  EXPECT_EQ(holding[0].from, 5);
  EXPECT_EQ(holding[0].to, 4);
  EXPECT_EQ(holding[1].from, 1);
  EXPECT_EQ(holding[1].to, 1);
  ASSERT_EQ(failing.size(), 2u);
  EXPECT_EQ(failing[0].from, 3);
  EXPECT_EQ(failing[0].to, 2);
}

TEST(Atlas, reports_where_a_method_holds_again) {
  const Atlas atlas{{examine(waves(), {.pictures = false}, [](double) {})}, {}};
  EXPECT_EQ(again_text(atlas.entries[0]), "holds again from 1 to 1.3 and at 2");
  EXPECT_THAT(atlas_text(atlas), HasSubstr("x; holds again from 1 to 1.3"));
  EXPECT_THAT(atlas_html(atlas), HasSubstr("; holds again from 1 to 1.3 and at 2."));
  const auto json = nlohmann::json::parse(atlas_json(atlas))["regions"][0]["holds_again"];
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[1], nlohmann::json({2, 2}));
  const Atlas once{{examine(step_at(0.3, {"x", 0, 2}), {.pictures = false}, [](double) {})}, {}};
  EXPECT_THAT(atlas_html(once) + atlas_text(once), Not(HasSubstr("holds again")));
}

TEST(Atlas, rounds_stretches_inwards) {
  Entry entry;
  entry.limit = 1;
  entry.sweep = {{1, 0}, {50, 2}, {149.6236, 0}, {1000.4, 0}};
  EXPECT_EQ(again_text(entry), "holds again from 149.7 to 1000");
  entry.sweep = {{1000.4, 0}, {500, 2}, {149.6236, 0}, {1e-9, 0}};
  EXPECT_EQ(again_text(entry), "holds again from 149.6 to 1e-09");
}

TEST(Atlas, shades_what_was_measured_to_fail) {
  const auto shades = [](const Region& region) {
    const std::string svg =
        sweep_chart(region, examine(region, {.pictures = false}, [](double) {}));
    int count = 0;
    for (std::size_t at = 0; (at = svg.find("fill = 'rgb(251, 227, 223)'", at)) != svg.npos; ++at) {
      ++count;
    }
    return count;
  };
  EXPECT_EQ(shades(waves()), 2);
  EXPECT_EQ(shades(step_at(0.3, {"x", 0, 2})), 1);
}

TEST(Atlas, text_distinguishes_the_sides) {
  EXPECT_EQ(boundary_text({{7, 0}, {6, 0}}), "7 -> 6");
  EXPECT_EQ(boundary_text({{0.30000001, 0}, {0.3000001, 0}}), "0.3 -> 0.3000001");
  EXPECT_EQ(boundary_text({{32767, 0}, {32768, 0}}), "32767 -> 32768");
  EXPECT_EQ(boundary_text({{0, 0}, {1, 0}}), "0 -> 1");
}

TEST(Atlas, rounds_each_side_away_from_the_other) {
  EXPECT_EQ(boundary_text({{0.8065002, 0}, {0.8064995, 0}}), "0.8065002 -> 0.8064995");
  EXPECT_EQ(boundary_text({{0.80650021, 0}, {0.80649951, 0}}), "0.8065003 -> 0.8064995");
  EXPECT_EQ(boundary_text({{0.005999755859, 0}, {0.006000518799, 0}}), "0.005999 -> 0.006001");
  EXPECT_EQ(boundary_text({{9.99996, 0}, {9.99986, 0}}), "10 -> 9.9998");
  EXPECT_EQ(boundary_text({{7.0073e-46, 0}, {7.0062e-46, 0}}), "7.008e-46 -> 7.006e-46");
}

TEST(Atlas, survives_json_with_its_pictures) {
  Region region = step_at(0.3, {"x", 0, 2});
  region.sketch = [](double x, int side) {
    Image image(side, side);
    image.pixels[0].color.r = x > 0.3 ? std::numeric_limits<float>::quiet_NaN() : 0;
    return image;
  };
  region.also = {{"twice", [](double x) { return 2 * x; }}};
  const Atlas atlas{{examine(region, {.side = 8}, [](double) {})}, {{"Lambert", 1, 0, -1}}};
  const Entry& entry = atlas.entries[0];
  EXPECT_EQ(entry.guarded_worst, 0.25);
  EXPECT_EQ(entry.also[0].fails, 4);
  EXPECT_EQ(entry.also[0].last_holding, 2 * entry.boundary.holds.x);
  EXPECT_EQ(entry.also[0].first_failing, 2 * entry.boundary.fails.x);
  ASSERT_EQ(entry.pictures.size(), 3u);  // chart, holds, fails
  const PrivateFolder folder;
  std::filesystem::create_directories(folder.path() / "step");
  for (const Picture& p : entry.pictures) write_file(folder.path() / "step" / p.file, p.png, "-o");
  const std::string json = atlas_json(atlas);
  EXPECT_EQ(atlas_json(read_atlas(json, folder.path(), "a")), json);
  EXPECT_EQ(atlas_html(read_atlas(json, folder.path(), "a")), atlas_html(atlas));
  EXPECT_TRUE(nlohmann::json::parse(json)["regions"][0]["fails"][1].is_null());
  std::filesystem::remove(folder.path() / "step" / "fails.png");
  EXPECT_TRUE(read_atlas(json, folder.path(), "a").entries.empty());
  EXPECT_THAT(atlas_html(atlas), HasSubstr("a &lt;step&gt;"));
}

TEST(Atlas, captions_tell_what_is_drawn) {
  Region region = step_at(0.3, {"x", 0, 2});
  region.sketch = region.guarded_sketch = [](double, int side) { return Image(side, side); };
  const auto captions = [&] {
    std::vector<std::string> all;
    for (const Picture& p : examine(region, {.side = 1}, [](double) {}).pictures) {
      all.push_back(p.caption);
    }
    return all;
  };
  EXPECT_THAT(captions(), ElementsAre("", "holds, 0", "fails, 2", "the remedy, 2",
                                      "fails less the remedy, times 256"));
  region.guarded_shows = [](double x) { return std::to_string(int(x) + 1) + " steps"; };
  EXPECT_THAT(captions(), Contains("the remedy, 3 steps"));
}

/// A grey picture.
Image grey_image(float value) {
  Image image(20, 20);
  for (RgbaPixel& pixel : image.pixels) pixel = {{value, value, value}, 1};
  return image;
}

TEST(Sketches, that_look_alike_are_shown_by_their_difference_at_a_gain_that_clips_nothing) {
  const auto found = difference_if_alike(grey_image(0.5f), grey_image(0.5f + 1.0f / 64));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->gain, 64);
  EXPECT_FLOAT_EQ(found->image.pixels[7].color.g, 1);
  EXPECT_EQ(difference_if_alike(grey_image(0.5f), grey_image(0.53f))->gain, 32);
}

TEST(Sketches, that_differ_by_less_than_eight_bits_show_are_still_told_apart) {
  const auto found = difference_if_alike(grey_image(0.5f), grey_image(0.5f + 0.3f / 255));
  EXPECT_EQ(found->gain, 256);
  EXPECT_NEAR(found->image.pixels[0].color.r, 256 * 0.3 / 255, 1e-4);  // of floats near 0.5
}

TEST(Sketches, that_anyone_can_tell_apart_need_no_difference) {
  EXPECT_FALSE(difference_if_alike(grey_image(0.2f), grey_image(0.4f)));
}

TEST(Sketches, differ_where_one_is_not_a_number) {
  Image broken = grey_image(0);
  broken.pixels[3].color.r = std::numeric_limits<float>::quiet_NaN();
  const auto found = difference_if_alike(grey_image(0), broken);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->image.pixels[3].color.r, 1);  // magenta against black
  EXPECT_EQ(found->image.pixels[3].color.g, 0);
}

TEST(Atlas, reports_the_remedys_worst_if_it_is_measured) {
  const auto html_of = [](const Region& region) {
    return atlas_html({{examine(region, {.pictures = false}, [](double) {})}, {}});
  };
  Region region = step_at(0.3, {"x", 0, 2});
  EXPECT_THAT(html_of(region), HasSubstr("worst over the sweep: 0.25"));
  region.guarded = nullptr;
  EXPECT_THAT(html_of(region), Not(HasSubstr("worst over the sweep")));
}

TEST(Atlas, refuses_what_is_not_an_atlas) {
  EXPECT_THROW(read_atlas("{}", ".", "a"), Error);
  EXPECT_THROW(read_atlas("x", ".", "a"), Error);
  const std::string other = R"({"version": "0.0.1", "regions": [], "energies": []})";
  EXPECT_THROW(read_atlas(other, ".", "a"), Error);
}

TEST(Atlas, shows_what_is_not_a_number_in_magenta) {
  Image broken(1, 1), magenta(1, 1);
  broken.pixels[0].color.g = std::numeric_limits<float>::infinity();
  magenta.pixels[0].color = {1, 0, 1};
  EXPECT_EQ(sketch_png(broken), sketch_png(magenta));
}

TEST(Energy, of_lambert_is_all_and_of_minnaert_what_its_integral_says) {
  const auto minnaert = [](double k) {
    return [k](const Directions<double>& d) { return MinnaertDiffuse::value(d, k); };
  };
  // Midpoints, and the guard of the product at 1e-4.
  EXPECT_NEAR(reflected_share(minnaert(1), 1.2), 1, 1e-9);
  EXPECT_NEAR(reflected_share(minnaert(0.5), 0), 2 / 1.5, 5e-3);  // infinite at the horizon
  EXPECT_NEAR(reflected_share(minnaert(3), 0.5), std::pow(std::cos(0.5), 2) * 2 / 4, 1e-4);
}

TEST(Energy, has_no_angle_where_all_are_alike) {
  const auto minnaert = [](double k) {
    return [k](const Directions<double>& d) { return MinnaertDiffuse::value(d, k); };
  };
  const std::vector<Energy> all{energy_of("Lambert", minnaert(1)),
                                energy_of("Minnaert", minnaert(2))};
  EXPECT_LT(all[0].at_degrees, 0);
  EXPECT_EQ(all[1].at_degrees, 0);
  const Atlas atlas{{}, all};
  EXPECT_THAT(atlas_text(atlas), HasSubstr("1 at every angle  never above 1"));
  EXPECT_THAT(atlas_html(atlas), HasSubstr("<td class=\"number\">every</td>"));
  const std::string json = atlas_json(atlas);
  EXPECT_TRUE(nlohmann::json::parse(json)["energies"][0]["at_degrees"].is_null());
  EXPECT_EQ(atlas_json(read_atlas(json, ".", "a")), json);
}

TEST(Energy, of_phong_head_on_is_two_by_k_plus_two) {
  for (const double k : {1.0, 10.0}) {
    const auto phong = [k](const Directions<double>& d) { return PhongHighlight::value(d, k); };
    EXPECT_NEAR(reflected_share(phong, 0), 2 / (k + 2), 1e-4);
  }
}

}  // namespace
}  // namespace lumaknot::stability
