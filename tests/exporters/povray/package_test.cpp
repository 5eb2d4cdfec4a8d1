#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exporters/image/file.h"
#include "exporters/povray/scene.h"
#include "tests/exporters/testing.h"

namespace lumaknot::povray {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::material;
using testing::names;
using ::testing::Not;
using testing::small_scene;

Scene scene_with(std::string_view name, Texture texture = testing::small_texture()) {
  Scene scene = small_scene(std::move(texture));
  scene.view.material = material(name);
  return scene;
}

TEST(PovPackage, luma_image_exists_only_where_light_acts_on_luma) {
  EXPECT_THAT(names(pov_package(scene_with("phong"), "k")), ElementsAre("k.texture.png", "k.pov"));
  for (const char* yiq : {"yiq-eq6", "yiq-table1"}) {
    EXPECT_THAT(names(pov_package(scene_with(yiq), "k")),
                ElementsAre("k.texture.png", "k.yiq-luma.png", "k.pov"));
  }
}

TEST(PovPackage, plain_color_needs_only_the_scene) {
  for (const NamedMaterial& named : paper_materials()) {
    EXPECT_THAT(names(pov_package(scene_with(named.name, Vec3d{0.5, 0.5, 0.5}), "k")),
                ElementsAre("k.pov"));
  }
}

TEST(PovPackage, scene_reads_its_image_files) {
  const Package package = pov_package(scene_with("yiq-eq6"), "my knot");
  const std::string& text = package.back().bytes;
  EXPECT_THAT(text, HasSubstr("\"my knot.texture.png\""));
  EXPECT_THAT(text, HasSubstr("\"my knot.yiq-luma.png\""));
  EXPECT_THAT(text, Not(HasSubstr("/tmp")));
  EXPECT_THAT(text, Not(HasSubstr(LUMAKNOT_SOURCE_DIR)));
}

TEST(PovPackage, scene_states_its_size_and_shortfall) {
  Scene scene = scene_with("yiq-table1");
  scene.view.image = {123, 45, 1};
  const std::string text = pov_package(scene, "k").back().bytes;
  EXPECT_THAT(text, HasSubstr("+W123 +H45"));
  EXPECT_THAT(text, HasSubstr("// POV-Ray can't clamp"));
  EXPECT_THAT(pov_package(scene_with("yiq-eq6"), "k").back().bytes, Not(HasSubstr("can't")));
}

TEST(PovPackage, gives_the_same_bytes_twice) {
  for (const NamedMaterial& named : paper_materials()) {
    const Package a = pov_package(scene_with(named.name), "k");
    const Package b = pov_package(scene_with(named.name), "k");
    ASSERT_EQ(names(a), names(b));
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].bytes, b[i].bytes) << a[i].name;
  }
}

std::vector<Shot> shots_of(std::initializer_list<const char*> formulas) {
  std::vector<Shot> shots;
  for (const char* formula : formulas) shots.push_back({formula, Stage::kFinal, material(formula)});
  return shots;
}

TEST(PovTextures, hold_the_texture_and_the_luma_of_each_space) {
  const testing::TemporaryFolder folder;
  const TextureImage texture = testing::small_texture();
  const Package package = pov_textures(
      texture, shots_of({"yuv709-phong", "yiq-phong", "rgb-phong", "yiq-baked-phong"}), "k.");
  ASSERT_THAT(names(package), ElementsAre("k.texture.png", "k.yiq-luma.png", "k.yuv709-luma.png"));
  write_package(folder.path(), package, "--output");
  EXPECT_EQ(read_texture(folder / "k.texture.png", "t").pixels, texture.pixels);
  const TextureImage yiq = read_texture(folder / "k.yiq-luma.png", "y");
  const TextureImage yuv = read_texture(folder / "k.yuv709-luma.png", "y");
  constexpr double kHalfStep = 0.5 / 65535 + 1e-7;  // of 16 bits, and float32
  for (std::size_t i = 0; i < texture.pixels.size(); ++i) {
    const Rgb& p = texture.pixels[i];
    const double y = 0.29889531 * p.r + 0.58662247 * p.g + 0.11448223 * p.b;
    EXPECT_NEAR(yiq.pixels[i].r, y, kHalfStep);
    EXPECT_EQ(yiq.pixels[i].r, yiq.pixels[i].b);
    EXPECT_NEAR(yuv.pixels[i].r, 0.2126 * p.r + 0.7152 * p.g + 0.0722 * p.b, kHalfStep);
  }
}

TEST(PovTextures, plain_color_needs_none) {
  EXPECT_THAT(pov_textures(Vec3d{}, shots_of({"yiq-phong"}), ""), IsEmpty());
}

TEST(PovPackage, refuses_what_would_be_another_formula) {
  EXPECT_EQ(error_of([] { pov_package(scene_with("cielab-phong"), "k"); }),
            "POV-Ray can't light the brightness of cielab alone; nearest: material.space \"yiq\"");
}

}  // namespace
}  // namespace lumaknot::povray
