#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exporters/image_file.h"
#include "exporters/pov.h"
#include "tests/exporters/exporters_testing.h"

namespace lumaknot {
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

TEST(PovPackage, luma_image_is_there_only_where_light_acts_on_luma) {
  EXPECT_THAT(names(pov_package(scene_with("phong"), "k")), ElementsAre("k.texture.png", "k.pov"));
  for (const char* yiq : {"yiq-eq6", "yiq-table1"}) {
    EXPECT_THAT(names(pov_package(scene_with(yiq), "k")),
                ElementsAre("k.texture.png", "k.luma.png", "k.pov"));
  }
}

TEST(PovPackage, plain_color_needs_the_scene_alone) {
  for (const NamedMaterial& named : named_materials()) {
    EXPECT_THAT(names(pov_package(scene_with(named.name, Vec3d{0.5, 0.5, 0.5}), "k")),
                ElementsAre("k.pov"));
  }
}

TEST(PovPackage, scene_reads_the_files_beside_it) {
  const Package package = pov_package(scene_with("yiq-eq6"), "my knot");
  const std::string& text = package.back().bytes;
  EXPECT_THAT(text, HasSubstr("\"my knot.texture.png\""));
  EXPECT_THAT(text, HasSubstr("\"my knot.luma.png\""));
  EXPECT_THAT(text, Not(HasSubstr("/tmp")));
  EXPECT_THAT(text, Not(HasSubstr(LUMAKNOT_SOURCE_DIR)));
}

TEST(PovPackage, scene_tells_its_size_and_what_it_falls_short_of) {
  Scene scene = scene_with("yiq-table1");
  scene.view.image = {123, 45, 1};
  const std::string text = pov_package(scene, "k").back().bytes;
  EXPECT_THAT(text, HasSubstr("+W123 +H45"));
  EXPECT_THAT(text, HasSubstr("// POV-Ray can't clamp"));
  EXPECT_THAT(pov_package(scene_with("yiq-eq6"), "k").back().bytes, Not(HasSubstr("can't")));
}

TEST(PovPackage, is_the_same_bytes_twice) {
  for (const NamedMaterial& named : named_materials()) {
    const Package a = pov_package(scene_with(named.name), "k");
    const Package b = pov_package(scene_with(named.name), "k");
    ASSERT_EQ(names(a), names(b));
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].bytes, b[i].bytes) << a[i].name;
  }
}

TEST(PovTextures, hold_the_texture_and_its_luma) {
  const testing::TemporaryFolder folder;
  const TextureImage texture = testing::small_texture();
  const Package package = pov_textures(small_scene(), {"t.png", "y.png"});
  ASSERT_THAT(names(package), ElementsAre("t.png", "y.png"));
  write_package(folder.path(), package, "--output");
  EXPECT_EQ(read_texture(folder / "t.png", "t").pixels, texture.pixels);
  const TextureImage luma = read_texture(folder / "y.png", "y");
  for (std::size_t i = 0; i < texture.pixels.size(); ++i) {
    const Rgb& p = texture.pixels[i];
    const double y = 0.29889531 * p.r + 0.58662247 * p.g + 0.11448223 * p.b;
    EXPECT_NEAR(luma.pixels[i].r, y, 0.5 / 65535 + 1e-7);  // half a step of 16 bits, and float32
    EXPECT_EQ(luma.pixels[i].r, luma.pixels[i].b);
  }
}

TEST(PovTextures, plain_color_needs_none) {
  EXPECT_THAT(pov_textures(small_scene(Vec3d{}), {"t.png", "y.png"}), IsEmpty());
}

}  // namespace
}  // namespace lumaknot
