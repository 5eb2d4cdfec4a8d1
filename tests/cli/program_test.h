/// The program, run in a folder of its own.
#pragma once

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scene/atomic_file.h"
#include "validate/process.h"

namespace lumaknot {

namespace fs = std::filesystem;

class Program : public ::testing::Test {
 protected:
  Ended lumaknot(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), LUMAKNOT_PROGRAM);
    return run_here(arguments, sanitizer_options());
  }
  /// Any program, of whose runs here no other is in the log.
  Ended run_here(const std::vector<std::string>& arguments,
                 const std::vector<std::string>& environment) {
    fs::remove(folder_.path() / (fs::path(arguments.front()).filename().string() + ".log"));
    return run({arguments, folder_.path(), environment}, std::chrono::seconds(60));
  }
  /// A program built with sanitizers needs the options that this test was given.
  static std::vector<std::string> sanitizer_options() {
    std::vector<std::string> options;
    for (const std::string name : {"ASAN_OPTIONS", "LSAN_OPTIONS"}) {
      if (const char* value = std::getenv(name.c_str())) options.push_back(name + "=" + value);
    }
    return options;
  }
  /// Expects exit code 2 and one line that holds `part`.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& part) {
    const Ended ended = lumaknot(arguments);
    EXPECT_EQ(ended.exit_code, 2) << ended.log;
    EXPECT_THAT(ended.log,
                ::testing::AllOf(::testing::StartsWith("lumaknot: "), ::testing::HasSubstr(part)));
    EXPECT_EQ(std::ranges::count(ended.log, '\n'), 1) << ended.log;
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(path(name)) << text;
  }
  std::string read(const std::string& name) { return read_file(path(name), name); }
  fs::path path(const std::string& name) const { return folder_.path() / name; }
  /// Everything in the folder but the program's log.
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

}  // namespace lumaknot
