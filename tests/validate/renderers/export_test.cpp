// The files of `lumaknot export`, run as a user would run them.
#include <gmock/gmock.h>

#include <filesystem>

#include "exporters/image/file.h"
#include "exporters/povray/scene.h"
#include "meshgen/knot_mesh.h"
#include "render/reference.h"
#include "scene/bricks.h"
#include "scene/presets.h"
#include "system/atomic_file.h"
#include "system/process.h"
#include "tests/system/exits_with.h"
#include "validate/compare/explain.h"

namespace lumaknot::validate {
namespace {

namespace fs = std::filesystem;

ProcessResult lumaknot_run(const PrivateFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), LUMAKNOT_PROGRAM);
  return run({arguments, folder.path(), {}}, std::chrono::seconds(120));
}

/// The mean of the largest differences of a channel, ours limited to [0, 1] if theirs is.
double mean_error(const Image& theirs, const Image& ours, bool limited) {
  double sum = 0;
  for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
    sum += channel_error(to_vec(ours.pixels[i].color), theirs.pixels[i].color, limited);
  }
  return sum / double(ours.pixels.size());
}

Image own_figure2() {
  const SceneSpec spec = *builtin_scene("figure2");
  return render({knot_mesh(std::get<KnotSpec>(spec.mesh)), bricks(), spec.view});
}

TEST(Export, pov_scene_renders_as_it_stands) {
  const PrivateFolder folder;
  ASSERT_THAT(lumaknot_run(folder, {"export", "figure2", "-o", "knot.pov"}), ExitsWith(0));
  const ProcessResult ended = run({{find_program("povray").string(), "+Iknot.pov", "+Oknot.png",
                                    "+W720", "+H720", "-A", "+UA", "+FN16", "File_Gamma=1.0", "-D"},
                                   folder.path(),
                                   {}},
                                  std::chrono::seconds(120));
  ASSERT_TRUE(ended.succeeded()) << ended.log;
  EXPECT_THAT(ended.log, ::testing::Not(::testing::HasSubstr("Parse Warning")));
  // POV-Ray turns about eighty normals at silhouettes; the rest is below a 16-bit step.
  EXPECT_LT(mean_error(read_image(folder.path() / "knot.png", 720, 720), own_figure2(), true),
            1e-4);
}

TEST(Export, blender_script_renders_as_it_stands) {
  const PrivateFolder folder;
  ASSERT_THAT(lumaknot_run(folder, {"export", "figure2", "-o", "knot.py"}), ExitsWith(0));
  const ProcessResult ended =
      run({{find_program("blender").string(), "-b", "--factory-startup", "--python-exit-code", "7",
            "--python", "knot.py", "--", "--render", "final=knot.exr"},
           folder.path(),
           {}},
          std::chrono::seconds(120));
  ASSERT_TRUE(ended.succeeded()) << ended.log;
  EXPECT_LT(mean_error(read_image(folder.path() / "knot.exr", 720, 720), own_figure2(), false),
            1e-5);
}

TEST(Export, blend_file_renders_alone_and_holds_no_path_of_this_machine) {
  const PrivateFolder folder;
  const ProcessResult exported = lumaknot_run(folder, {"export", "figure2", "-o", "knot.blend"});
  ASSERT_THAT(exported, ExitsWith(0));
  const ProcessResult ended =
      run({{find_program("blender").string(), "-b", "knot.blend", "-o",
            (folder.path() / "frame").string(), "-F", "OPEN_EXR", "-f", "1"},
           folder.path(),
           {}},
          std::chrono::seconds(120));
  ASSERT_TRUE(ended.succeeded()) << ended.log;
  // The scene itself leaves file extensions off: frame0001.
  EXPECT_LT(mean_error(read_image(folder.path() / "frame0001", 720, 720), own_figure2(), false),
            1e-5);
}

TEST(Doctor, finds_the_renderers_and_their_versions) {
  const PrivateFolder folder;
  const ProcessResult ended = lumaknot_run(folder, {"doctor"});
  EXPECT_THAT(ended, ExitsWith(0));
  EXPECT_THAT(ended.log, ::testing::ContainsRegex("Cycles +found +Blender [0-9]"));
  EXPECT_THAT(ended.log, ::testing::ContainsRegex("POV-Ray +found +POV-Ray [0-9]"));
}

}  // namespace
}  // namespace lumaknot::validate
