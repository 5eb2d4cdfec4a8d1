#include "system/process.h"

#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "tests/system/exits_with.h"

namespace lumaknot {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;

ProcessResult shell(const PrivateFolder& folder, const std::string& script,
                    std::chrono::duration<double> limit = 20s) {
  return run({{"/bin/sh", "-c", script}, folder.path(), {"COLOR=blue"}}, limit);
}

TEST(Process, reports_exit_code_and_both_streams) {
  const PrivateFolder folder;
  const ProcessResult ended = shell(folder, "echo out; echo err >&2; exit 3");
  EXPECT_THAT(ended, ExitsWith(3));
  EXPECT_FALSE(ended.succeeded());
  EXPECT_EQ(ended.log, "out\nerr\n");
}

TEST(Process, reports_the_signal_that_ended_a_program) {
  const PrivateFolder folder;
  EXPECT_THAT(shell(folder, "kill -SEGV $$"), ExitsWith(128 + SIGSEGV));
}

TEST(Process, runs_in_its_folder_with_an_environment_of_its_own) {
  const PrivateFolder folder;
  ::setenv("LUMAKNOT_TEST_SECRET", "visible", 1);
  const ProcessResult ended = shell(folder, "pwd; env");
  EXPECT_THAT(ended.log, HasSubstr(folder.path().string() + "\n"));
  EXPECT_THAT(ended.log, HasSubstr("COLOR=blue"));
  EXPECT_THAT(ended.log, HasSubstr("HOME=" + folder.path().string()));
  EXPECT_THAT(ended.log, Not(HasSubstr("LUMAKNOT_TEST_SECRET")));
}

TEST(Process, passes_arguments_unchanged) {
  const PrivateFolder folder;
  const ProcessResult ended =
      run({{"/bin/echo", "a b", "$HOME", "*", "; false"}, folder.path(), {}}, 20s);
  EXPECT_EQ(ended.log, "a b $HOME * ; false\n");
}

/// Whether the process whose number the script wrote to "child" is gone within five seconds. A
/// killed orphan stays a zombie until init reaps it; it is no longer running.
bool child_ends(const PrivateFolder& folder) {
  int child = 0;
  std::ifstream(folder.path() / "child") >> child;
  for (int tries = 0; child > 0 && tries < 100; ++tries) {
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    const std::string text((std::istreambuf_iterator<char>(stat)), {});
    if (text.empty() || text.find(") Z ") != std::string::npos) return true;
    std::this_thread::sleep_for(50ms);
  }
  return false;
}

TEST(Process, is_killed_with_its_children_at_its_limit) {
  const PrivateFolder folder;
  const ProcessResult ended = shell(folder, "sleep 600 & echo $! > child; sleep 600", 0.3s);
  EXPECT_TRUE(ended.timed_out);
  EXPECT_FALSE(ended.succeeded());
  EXPECT_LT(ended.seconds, 10);  // not the 600 of the command
  EXPECT_TRUE(child_ends(folder)) << "the child outlived its group";
}

TEST(Process, leaves_no_child_behind_when_it_succeeds) {
  const PrivateFolder folder;
  const ProcessResult ended = shell(folder, "sleep 600 & echo $! > child");
  EXPECT_TRUE(ended.succeeded());
  EXPECT_TRUE(child_ends(folder)) << "the child outlived its parent";
}

TEST(Process, keeps_the_end_of_a_long_log) {
  const PrivateFolder folder;
  const ProcessResult ended = shell(folder, "seq 1 100000");
  EXPECT_LE(ended.log.size(), 65'536u);
  EXPECT_THAT(ended.log, ::testing::EndsWith("100000\n"));
}

TEST(Process, that_cannot_start_throws) {
  const PrivateFolder folder;
  EXPECT_THROW(run({{"/nonexistent/program"}, folder.path(), {}}, 1s), std::runtime_error);
}

TEST(PrivateFolder, is_removed_with_its_contents) {
  std::filesystem::path path;
  {
    const PrivateFolder folder;
    path = folder.path();
    std::ofstream(path / "file") << "text";
    const auto mode = std::filesystem::status(path).permissions();
    EXPECT_EQ(mode, std::filesystem::perms::owner_all) << "nobody else may look inside";
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(FindProgram, looks_in_path_and_accepts_a_path_unchanged) {
  EXPECT_TRUE(find_program("sh").is_absolute());
  EXPECT_EQ(find_program("/bin/sh"), "/bin/sh");
  EXPECT_TRUE(find_program("no-such-program-here").empty());
  EXPECT_TRUE(find_program("/etc/passwd").empty()) << "not executable";
}

}  // namespace
}  // namespace lumaknot
