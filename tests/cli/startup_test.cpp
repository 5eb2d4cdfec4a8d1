// What a start of the program costs, and where it finds the module that reads and writes images.
#include <gmock/gmock.h>

#include <string>

#include "tests/cli/program_test.h"

namespace lumaknot {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kModule = "liblumaknot-images.so";

/// The bar of a refusal, in MiB.
constexpr double kMostMemory = 64;

/// With sanitizers the program's checks and their data alone are ten times the program.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// Runs a program and prints the most memory that it held, in KiB. Python starts it since a child
/// of this test would be charged with the memory of the test.
constexpr const char* kMeasure =
    "import resource, subprocess, sys; subprocess.run(sys.argv[1:], capture_output=True); "
    "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)";

class Startup : public Program {
 protected:
  /// Scenes whose texture is not there, or no image.
  void write_bad_scenes() {
    write("no-texture.json", R"({"texture": {"file": "missing.png"}})");
    write("bad-texture.json", R"({"texture": {"file": "words.png"}})");
    write("words.png", "only words");
  }

  /// What the dynamic loader says about the files that the program loads.
  std::string loader_log(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), LUMAKNOT_PROGRAM);
    std::vector<std::string> environment = sanitizer_options();
    environment.push_back("LD_DEBUG=files");
    environment.push_back("LD_DEBUG_OUTPUT=" + path("loader").string());
    run({arguments, folder_.path(), environment}, std::chrono::seconds(60));
    std::string log;
    for (const std::string& name : files()) {
      if (!name.starts_with("loader.")) continue;
      log += read(name);
      fs::remove(path(name));
    }
    return log;
  }

  /// The most memory that the program holds, in MiB.
  double peak_memory(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"/usr/bin/python3", "-c", kMeasure, LUMAKNOT_PROGRAM});
    const Ended ended =
        run({arguments, folder_.path(), sanitizer_options()}, std::chrono::seconds(60));
    return std::stod(ended.log) / 1024;
  }

  /// A copy of the program in a folder of its own, with the module beside it or without.
  fs::path moved_program(bool with_module) {
    const fs::path program = LUMAKNOT_PROGRAM, folder = path("moved");
    fs::create_directories(folder);
    fs::copy_file(program, folder / "lumaknot");
    if (with_module) fs::copy_file(program.parent_path() / kModule, folder / kModule);
    return folder / "lumaknot";
  }

  Ended run_with_texture(std::vector<std::string> program) {
    write("scene.json", R"({"texture": {"file": "garbage.bmp"}})");
    write("garbage.bmp", "BM, and then only words");  // which OpenImageIO alone finds wrong
    for (const char* argument : {"render", "scene.json", "-o", "out.png"}) {
      program.push_back(argument);
    }
    return run({program, folder_.path(), sanitizer_options()}, std::chrono::seconds(60));
  }
};

/// Commands that meet no image, most of them refused.
std::vector<std::vector<std::string>> commands_without_images() {
  return {{"--version"},
          {"mesh", "--p", "0", "--q", "0", "-o", "x.obj"},
          {"scene", "figure2"},
          {"render", "missing.json", "-o", "x.png"},
          {"render", "no-texture.json", "-o", "x.png"},
          {"render", "bad-texture.json", "-o", "x.png"},
          {"render", "figure2", "-o", "missing/x.png"},
          {"export", "figure2", "-o", "missing/x.pov"}};
}

TEST_F(Startup, commands_that_meet_no_image_load_no_image_library) {
  write_bad_scenes();
  for (const auto& arguments : commands_without_images()) {
    const std::string log = loader_log(arguments);
    EXPECT_THAT(log, HasSubstr("libstdc++")) << "the loader told nothing";
    EXPECT_THAT(log, Not(HasSubstr("OpenImageIO"))) << ::testing::PrintToString(arguments);
  }
  EXPECT_THAT(loader_log({"render", "figure2", "-o", "out.png"}), HasSubstr("libOpenImageIO.so"));
}

TEST_F(Startup, commands_that_meet_no_image_take_less_than_64_mib) {
  write_bad_scenes();
  // So there the bar is on what a command takes beyond the start of the program.
  const double start = kSanitized ? peak_memory({"--version"}) : 0;
  for (const auto& arguments : commands_without_images()) {
    EXPECT_LT(peak_memory(arguments) - start, kMostMemory) << ::testing::PrintToString(arguments);
  }
}

TEST_F(Startup, a_moved_program_finds_its_module_through_a_link_and_the_path) {
  const fs::path program = moved_program(true);
  fs::create_symlink(program, path("link"));
  write("by-path.sh", "PATH=" + program.parent_path().string() + " && exec lumaknot \"$@\"");
  const std::string by_path = path("by-path.sh").string();
  for (const auto& start : std::vector<std::vector<std::string>>{
           {program.string()}, {path("link").string()}, {"/bin/sh", by_path}}) {
    // The words of OpenImageIO's exception come through.
    EXPECT_THAT(run_with_texture(start).log, HasSubstr("garbage.bmp can't be read as a texture"));
  }
}

TEST_F(Startup, a_missing_module_is_refused_with_the_remedy) {
  const Ended ended = run_with_texture({moved_program(false).string()});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.log, HasSubstr(std::string("lumaknot: ") + kModule + " is needed"));
  EXPECT_THAT(ended.log, HasSubstr("keep that file beside the program"));
  EXPECT_EQ(std::ranges::count(ended.log, '\n'), 1) << ended.log;
  EXPECT_FALSE(fs::exists(path("out.png")));
}

TEST_F(Startup, a_broken_module_is_refused_with_the_remedy) {
  write("broken", "only words");
  const fs::path program = moved_program(false);
  fs::copy_file(path("broken"), program.parent_path() / kModule);
  const Ended ended = run_with_texture({program.string()});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.log, HasSubstr("keep that file beside the program"));
  EXPECT_EQ(std::ranges::count(ended.log, '\n'), 1) << ended.log;
}

}  // namespace
}  // namespace lumaknot
