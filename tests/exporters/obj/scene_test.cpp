#include "exporters/obj/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exporters/image/file.h"
#include "tests/exporters/testing.h"

namespace lumaknot::obj {
namespace {

using testing::bytes_at;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::names;
using ::testing::Not;
using testing::small_scene;
using ::testing::StartsWith;
using testing::TemporaryFolder;
using ::testing::UnorderedElementsAre;

TEST(ObjMaterials, material_has_the_scenes_numbers) {
  Scene scene = small_scene();
  scene.view.material.diffuse = 0.5;
  scene.view.material.diffuse_color = {1, 0.5, 0.25};
  scene.view.material.specular = 0.75;
  scene.view.material.parameters["shininess"] = 20;
  const Package package = obj_materials(scene, "k");
  ASSERT_THAT(names(package), ElementsAre("k.texture.png", "k.mtl"));
  EXPECT_EQ(package.back().bytes,
            "# Made by lumaknot\nnewmtl lumaknot\nKd 0.5 0.25 0.125\nKs 0.75 0.75 0.75\nNs 20\n"
            "illum 2\nmap_Kd k.texture.png\n");
}

TEST(ObjMaterials, plain_color_is_the_diffuse_color) {
  Scene scene = small_scene(Vec3d{0.5, 0.25, 1});
  scene.view.material.diffuse_color = {1, 0.5, 0.5};
  const Package package = obj_materials(scene, "k");
  ASSERT_THAT(names(package), ElementsAre("k.mtl"));
  EXPECT_THAT(package.back().bytes, HasSubstr("\nKd 0.5 0.125 0.5\n"));
  EXPECT_THAT(package.back().bytes, Not(HasSubstr("map_Kd")));
}

TEST(ObjMaterials, numbers_keep_to_the_ranges_of_mtl) {
  Scene scene = small_scene();
  scene.view.material.specular = 3;
  scene.view.material.parameters["shininess"] = 5000;
  const std::string text = obj_materials(scene, "k").back().bytes;
  EXPECT_THAT(text, HasSubstr("\nKs 1 1 1\nNs 1000\n"));
}

TEST(WriteObjScene, files_name_each_other_without_characters_that_end_a_name) {
  const TemporaryFolder folder;
  const Scene scene = small_scene();
  const auto written = write_obj_scene(folder / "my #1 knot.obj", scene.mesh,
                                       obj_materials(scene, "my #1 knot"), "--output");
  EXPECT_THAT(written, ElementsAre("my__1_knot.texture.png", "my__1_knot.mtl", "my #1 knot.obj"));
  EXPECT_THAT(folder.names(),
              UnorderedElementsAre("my__1_knot.texture.png", "my__1_knot.mtl", "my #1 knot.obj"));
  const std::string text = bytes_at(folder / "my #1 knot.obj");
  EXPECT_THAT(text, StartsWith("mtllib my__1_knot.mtl\nusemtl lumaknot\nv "));
  EXPECT_EQ(testing::lines_with(text, "f "), int(scene.mesh.triangles.size()));
  EXPECT_THAT(bytes_at(folder / "my__1_knot.mtl"), HasSubstr("map_Kd my__1_knot.texture.png\n"));
  EXPECT_EQ(read_texture(folder / "my__1_knot.texture.png", "t").pixels,
            std::get<TextureImage>(scene.texture).pixels);
}

}  // namespace
}  // namespace lumaknot::obj
