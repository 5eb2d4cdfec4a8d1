// The cost of starting the program, and where it finds the module that reads and writes images.
#include <gmock/gmock.h>

#include <string>

#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kModule = "liblumaknot-images.so";

/// The limit for a refused command, in MiB.
constexpr double kMaxMemory = 64;

/// Sanitizers use ten times the memory of the program.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// Runs a program and prints its peak memory in KiB. Python starts it since a child of this test
/// would be charged with the memory of the test.
constexpr const char* kMeasure =
    "import resource, subprocess, sys; subprocess.run(sys.argv[1:], capture_output=True); "
    "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)";

class Startup : public Program {
 protected:
  /// Scenes whose texture is missing or not an image.
  void write_bad_scenes() {
    write("no-texture.json", R"({"texture": {"file": "missing.png"}})");
    write("bad-texture.json", R"({"texture": {"file": "words.png"}})");
    write("words.png", "only words");
  }

  /// What the dynamic loader logs about the files that the program loads.
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

  /// The peak memory of the program, in MiB.
  double peak_memory(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"/usr/bin/python3", "-c", kMeasure, LUMAKNOT_PROGRAM});
    const ProcessResult result =
        run({arguments, folder_.path(), sanitizer_options()}, std::chrono::seconds(60));
    return std::stod(result.log) / 1024;
  }

  /// A copy of the program in its own folder, with or without the module next to it.
  fs::path moved_program(bool with_module) {
    const fs::path program = LUMAKNOT_PROGRAM, folder = path("moved");
    fs::create_directories(folder);
    fs::copy_file(program, folder / "lumaknot");
    if (with_module) fs::copy_file(program.parent_path() / kModule, folder / kModule);
    return folder / "lumaknot";
  }

  ProcessResult run_with_texture(std::vector<std::string> program) {
    write("scene.json", R"({"texture": {"file": "garbage.bmp"}})");
    write("garbage.bmp", "BM, and then only words");  // which only OpenImageIO rejects
    for (const char* argument : {"render", "scene.json", "-o", "out.png"}) {
      program.push_back(argument);
    }
    return run({program, folder_.path(), sanitizer_options()}, std::chrono::seconds(60));
  }
};

/// Commands that use no image, most of them refused.
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

TEST_F(Startup, commands_without_images_load_no_image_library) {
  write_bad_scenes();
  for (const auto& arguments : commands_without_images()) {
    const std::string log = loader_log(arguments);
    EXPECT_THAT(log, HasSubstr("libstdc++")) << "the loader logged nothing";
    EXPECT_THAT(log, Not(HasSubstr("OpenImageIO"))) << ::testing::PrintToString(arguments);
  }
  EXPECT_THAT(loader_log({"render", "figure2", "-o", "out.png"}), HasSubstr("libOpenImageIO.so"));
}

TEST_F(Startup, commands_without_images_take_less_than_64_mib) {
  write_bad_scenes();
  // With sanitizers, only what a command takes beyond the start of the program counts.
  const double start = kSanitized ? peak_memory({"--version"}) : 0;
  for (const auto& arguments : commands_without_images()) {
    EXPECT_LT(peak_memory(arguments) - start, kMaxMemory) << ::testing::PrintToString(arguments);
  }
}

TEST_F(Startup, a_moved_program_finds_its_module_through_a_link_and_the_path) {
  const fs::path program = moved_program(true);
  fs::create_symlink(program, path("link"));
  write("by-path.sh", "PATH=" + program.parent_path().string() + " && exec lumaknot \"$@\"");
  const std::string by_path = path("by-path.sh").string();
  for (const auto& start : std::vector<std::vector<std::string>>{
           {program.string()}, {path("link").string()}, {"/bin/sh", by_path}}) {
    // The message of OpenImageIO's exception is reported.
    EXPECT_THAT(run_with_texture(start).log, HasSubstr("garbage.bmp can't be read as a texture"));
  }
}

TEST_F(Startup, a_missing_module_is_refused_with_the_remedy) {
  const ProcessResult result = run_with_texture({moved_program(false).string()});
  EXPECT_THAT(result, ExitsWith(2));
  EXPECT_THAT(result.log, HasSubstr(std::string("lumaknot: ") + kModule + " is needed"));
  EXPECT_THAT(result.log, HasSubstr("keep that file next to the program"));
  EXPECT_EQ(std::ranges::count(result.log, '\n'), 1) << result.log;
  EXPECT_FALSE(fs::exists(path("out.png")));
}

TEST_F(Startup, a_broken_module_is_refused_with_the_remedy) {
  write("broken", "only words");
  const fs::path program = moved_program(false);
  fs::copy_file(path("broken"), program.parent_path() / kModule);
  const ProcessResult result = run_with_texture({program.string()});
  EXPECT_THAT(result, ExitsWith(2));
  EXPECT_THAT(result.log, HasSubstr("keep that file next to the program"));
  EXPECT_EQ(std::ranges::count(result.log, '\n'), 1) << result.log;
}

}  // namespace
}  // namespace lumaknot::cli
