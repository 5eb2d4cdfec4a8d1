#include "system/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <thread>

#include "tests/scene/error_of.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A folder of its own for each test, removed afterwards.
class AtomicFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "lumaknot-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder = pattern;
  }
  void TearDown() override { fs::remove_all(folder); }

  std::size_t entries() const {
    return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  fs::path folder;
};

/// Limits files to `bytes` during its lifetime, like a full disk, for any user.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_{};
  void (*handler_)(int);
};

TEST_F(AtomicFileTest, written_bytes_are_read_back) {
  const std::string bytes("a\0b\r\n\xff", 6);
  write_file(folder / "a.bin", bytes, "--output");
  EXPECT_EQ(read_file(folder / "a.bin", "input"), bytes);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, an_empty_file_can_be_written) {
  write_file(folder / "a", "", "--output");
  EXPECT_EQ(read_file(folder / "a", "input"), "");
}

TEST_F(AtomicFileTest, a_second_write_replaces_the_first) {
  write_file(folder / "a", "a long first text", "--output");
  write_file(folder / "a", "second", "--output");
  EXPECT_EQ(read_file(folder / "a", "input"), "second");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, without_a_commit_the_old_content_stays_and_the_temporary_is_removed) {
  write_file(folder / "a.txt", "old", "--output");
  {
    AtomicFile file(folder / "a.txt", "--output");
    std::ofstream(file.temporary()) << "half";
    EXPECT_EQ(read_file(folder / "a.txt", "input"), "old");
    EXPECT_EQ(entries(), 2u);
  }
  EXPECT_EQ(read_file(folder / "a.txt", "input"), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, without_a_commit_a_new_file_never_appears) {
  {
    AtomicFile file(folder / "a.txt", "--output");
  }
  EXPECT_EQ(entries(), 0u);
}

TEST_F(AtomicFileTest, the_temporary_is_next_to_the_file_and_keeps_its_extension) {
  AtomicFile file(folder / "a.obj", "--output");
  EXPECT_EQ(file.temporary().parent_path(), folder);
  EXPECT_EQ(file.temporary().extension(), ".obj");
  EXPECT_NE(file.temporary(), folder / "a.obj");
}

TEST_F(AtomicFileTest, files_of_one_stem_and_two_extensions_do_not_collide) {
  AtomicFile a(folder / "a.obj", "--output"), b(folder / "a.ply", "--output");
  EXPECT_NE(a.temporary(), b.temporary());
}

TEST_F(AtomicFileTest, a_missing_folder_is_an_error_that_names_flag_and_path) {
  const fs::path path = folder / "missing" / "a.txt";
  const std::string message = error_of([&] { write_file(path, "x", "--output"); });
  EXPECT_THAT(message, HasSubstr("--output"));
  EXPECT_THAT(message, HasSubstr(path.string()));
  EXPECT_THAT(message, HasSubstr("choose another place"));
  EXPECT_THAT(message, Not(HasSubstr("\n")));
}

TEST_F(AtomicFileTest, a_folder_that_is_a_file_is_an_error) {
  write_file(folder / "a", "old", "--output");
  EXPECT_THAT(error_of([&] { write_file(folder / "a" / "b", "x", "--report"); }),
              HasSubstr("--report"));
  EXPECT_EQ(read_file(folder / "a", "input"), "old");
}

TEST_F(AtomicFileTest, a_path_that_is_a_folder_is_an_error_that_says_so) {
  EXPECT_THAT(error_of([&] { write_file(folder, "x", "--output"); }), HasSubstr("folder"));
  EXPECT_EQ(entries(), 0u);
}

TEST_F(AtomicFileTest, a_folder_without_write_permission_is_an_error) {
  // For root every folder is writable; /proc accepts no files.
  const fs::path path = ::geteuid() == 0 ? fs::path("/proc/a.txt") : folder / "a.txt";
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  const std::string message = error_of([&] { write_file(path, "x", "--output"); });
  fs::permissions(folder, fs::perms::owner_all);
  EXPECT_THAT(message, HasSubstr("--output " + path.string()));
}

TEST_F(AtomicFileTest, a_full_disk_leaves_the_old_content_and_nothing_else) {
  write_file(folder / "a", "old", "--output");
  const std::string bytes(1'000'000, 'x');
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = error_of([&] { write_file(folder / "a", bytes, "--output"); });
  }
  EXPECT_THAT(message, HasSubstr("--output"));
  EXPECT_EQ(read_file(folder / "a", "input"), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, a_failed_rename_is_an_error_and_the_temporary_is_removed) {
  const std::string message = error_of([&] {
    AtomicFile file(folder / "a", "--output");
    fs::create_directories(folder / "a" / "b");  // another process was faster
    file.commit();
  });
  EXPECT_THAT(message, HasSubstr("--output"));
  EXPECT_EQ(entries(), 1u);
  EXPECT_TRUE(fs::is_directory(folder / "a" / "b"));
}

TEST_F(AtomicFileTest, a_file_of_any_size_is_read_whole) {
  for (const std::size_t size : {1u, 65535u, 65536u, 65537u, 1'000'000u}) {
    std::string bytes(size, 'x');
    bytes.back() = 'y';
    write_file(folder / "a", bytes, "--output");
    EXPECT_EQ(read_file(folder / "a", "input"), bytes) << size;
  }
}

TEST_F(AtomicFileTest, a_pipe_that_reports_no_size_is_read_whole) {
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const std::string bytes(200'000, 'x');
  std::thread writer([&] { std::ofstream(folder / "pipe") << bytes; });
  EXPECT_EQ(read_file(folder / "pipe", "input"), bytes);
  writer.join();
}

TEST_F(AtomicFileTest, reading_a_missing_file_or_a_folder_names_the_label_and_the_path) {
  const std::string missing = error_of([&] { read_file(folder / "a.json", "scene"); });
  EXPECT_THAT(missing, HasSubstr("scene"));
  EXPECT_THAT(missing, HasSubstr((folder / "a.json").string()));
  EXPECT_THAT(error_of([&] { read_file(folder, "scene"); }), HasSubstr("folder"));
}

TEST_F(AtomicFileTest, checking_a_place_changes_nothing) {
  write_file(folder / "old.txt", "old", "--output");
  check_writable(folder / "old.txt", "--output");
  check_writable(folder / "new.txt", "--output");
  EXPECT_EQ(read_file(folder / "old.txt", "file"), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFileTest, checking_a_place_refuses_what_writing_would_refuse) {
  for (const fs::path& bad : {folder, folder / "missing" / "a.txt"}) {
    const std::string error = error_of([&] { check_writable(bad, "--output"); });
    EXPECT_THAT(error, HasSubstr("--output " + bad.string() + " can't be written"));
    EXPECT_EQ(error, error_of([&] { write_file(bad, "x", "--output"); }));
  }
}

}  // namespace
}  // namespace lumaknot
