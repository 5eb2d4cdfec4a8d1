/// A fixture that runs the program in its own folder.
#pragma once

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "system/atomic_file.h"
#include "system/process.h"
#include "tests/system/exits_with.h"

namespace lumaknot::cli {

namespace fs = std::filesystem;

class Program : public ::testing::Test {
 protected:
  ProcessResult lumaknot(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), LUMAKNOT_PROGRAM);
    return run_here(arguments, sanitizer_options());
  }
  /// Runs any program, with a fresh log.
  ProcessResult run_here(const std::vector<std::string>& arguments,
                         const std::vector<std::string>& environment) {
    fs::remove(folder_.path() / (fs::path(arguments.front()).filename().string() + ".log"));
    // Against a program that hangs: a busy machine takes ten times as long as an idle one.
    return run({arguments, folder_.path(), environment}, std::chrono::seconds(180));
  }
  /// The sanitizer options of this test, which a program built with sanitizers needs too.
  static std::vector<std::string> sanitizer_options() {
    std::vector<std::string> options;
    for (const std::string name : {"ASAN_OPTIONS", "LSAN_OPTIONS"}) {
      if (const char* value = std::getenv(name.c_str())) options.push_back(name + "=" + value);
    }
    return options;
  }
  /// Expects exit code 2 and a single line that contains `part`.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& part) {
    const ProcessResult result = lumaknot(arguments);
    EXPECT_THAT(result, ExitsWith(2));
    EXPECT_THAT(result.log,
                ::testing::AllOf(::testing::StartsWith("lumaknot: "), ::testing::HasSubstr(part)));
    EXPECT_EQ(std::ranges::count(result.log, '\n'), 1) << result.log;
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(path(name)) << text;
  }
  std::string read(const std::string& name) { return read_file(path(name), name); }
  fs::path path(const std::string& name) const { return folder_.path() / name; }
  /// Everything in the folder except the program's log.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      const std::string name = entry.path().filename().string();
      if (name != "lumaknot.log") names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
  }

  PrivateFolder folder_;
};

}  // namespace lumaknot::cli
