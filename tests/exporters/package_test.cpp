#include "exporters/package.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/exporters/testing.h"

namespace lumaknot {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::TemporaryFolder;
using ::testing::UnorderedElementsAre;

TEST(CheckPackageName, names_that_would_end_a_quoted_text_are_refused) {
  for (const char* name : {"a'b.py", "a\"b.py", "a\\b.py", "a\nb.py", "a\tb.py", "a\x7f.py",
                           "\x01.py", "'''.py", "folder/a'b.py"}) {
    const std::string error = error_of([&] { check_package_name(name, "--output"); });
    EXPECT_THAT(error, HasSubstr("--output")) << name;
    EXPECT_THAT(error, HasSubstr("quotes or backslashes")) << name;
  }
}

TEST(CheckPackageName, names_that_are_not_utf_8_are_refused) {
  // A lone byte of Latin-1, a cut sequence, a slash in two bytes, half of a surrogate pair.
  for (const char* name : {"caf\xe9.py", "a\xc5", "a\xc0\xaf.py", "a\xed\xa0\x80.py"}) {
    EXPECT_THAT(error_of([&] { check_package_name(name, "--output"); }),
                HasSubstr("must be UTF-8"));
  }
}

TEST(CheckPackageName, ordinary_names_pass) {
  for (const char* name : {"knot.py", "my knot.py", "k-1_2.3.py", "{knot}.py", "100%.py",
                           "n\xc5\x93ud.py", "it's/knot.py"}) {
    EXPECT_EQ(error_of([&] { check_package_name(name, "--output"); }), "") << name;
  }
}

TEST(WritePackage, every_file_is_written_unchanged) {
  const TemporaryFolder folder;
  const std::string bytes("\0\r\n\xff", 4);
  write_package(folder.path(), {{"a.bin", bytes}, {"b.txt", ""}}, "--output");
  EXPECT_THAT(folder.names(), UnorderedElementsAre("a.bin", "b.txt"));
  EXPECT_EQ(testing::bytes_at(folder / "a.bin"), bytes);
  EXPECT_EQ(testing::bytes_at(folder / "b.txt"), "");
}

TEST(WritePackage, the_file_that_is_opened_is_missing_when_another_cannot_be_written) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a.bin");  // in place of a file
  const std::string error =
      error_of([&] { write_package(folder.path(), {{"a.bin", "x"}, {"b.py", "y"}}, "--output"); });
  EXPECT_THAT(error, HasSubstr("--output"));
  EXPECT_FALSE(std::filesystem::exists(folder / "b.py"));
}

TEST(WritePackage, missing_folder_is_refused_naming_the_flag) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of([&] { write_package(folder / "none", {{"a", "x"}}, "--output"); }),
              HasSubstr("--output"));
  EXPECT_THAT(folder.names(), IsEmpty());
}

}  // namespace
}  // namespace lumaknot
