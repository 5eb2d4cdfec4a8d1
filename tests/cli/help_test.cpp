// The help and manual pages of every command, built from the commands' data.
#include "cli/describe/help.h"

#include <gmock/gmock.h>

#include <sstream>

#include "cli/command_table.h"
#include "cli/parser.h"
#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class Help : public Program {
 protected:
  const std::vector<Subcommand> commands_ = all_commands();

  ProcessResult lumaknot_at(const std::string& columns, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), LUMAKNOT_PROGRAM);
    std::vector<std::string> environment = sanitizer_options();
    environment.push_back("COLUMNS=" + columns);
    return run_here(arguments, environment);
  }
};

std::size_t longest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
  return longest;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string one_line(const std::string& text) {
  std::string line;
  for (const std::string& word : words_of(text)) line += (line.empty() ? "" : " ") + word;
  return line;
}

/// The arguments with which a shell line runs the program: "source <(lumaknot completion bash)".
std::vector<std::string> arguments_of(std::string_view line) {
  constexpr std::string_view kProgramName = "lumaknot ";
  line.remove_prefix(std::min(line.size(), line.find(kProgramName) + kProgramName.size()));
  return words_of(std::string(line.substr(0, line.find_first_of(">|)"))));
}

TEST_F(Help, every_file_of_a_command_is_in_the_table) {
  std::vector<std::string> files, names;
  for (const auto& entry : fs::directory_iterator(fs::path(LUMAKNOT_SOURCE_DIR) / "cli/commands")) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = read_file(entry.path(), stem);
    if (text.find("Subcommand " + stem + "_command()") != text.npos) files.push_back(stem);
  }
  for (const Subcommand& command : commands_) names.emplace_back(command.name);
  std::ranges::sort(files);
  std::ranges::sort(names);
  EXPECT_EQ(files, names) << "a command is missing in kCommands of cli/command_table.cpp";
}

TEST_F(Help, of_every_command_lists_its_flags_and_has_examples) {
  for (const Subcommand& command : commands_) {
    const ProcessResult result = lumaknot({std::string(command.name), "--help"});
    EXPECT_THAT(result, ExitsWith(0));
    EXPECT_THAT(result.log,
                AllOf(StartsWith(std::string(command.about)), HasSubstr("\nExamples:\n"),
                      HasSubstr("lumaknot " + std::string(command.name))));
    for (const Argument& argument : command.arguments) {
      EXPECT_THAT(result.log, HasSubstr("  " + label(argument)));
      EXPECT_FALSE(argument.meaning.empty()) << command.name << " " << argument.names;
    }
  }
}

TEST_F(Help, of_the_program_lists_every_command_by_purpose) {
  const std::string help = lumaknot({"--help"}).log;
  for (const Subcommand& command : commands_) {
    const auto row = HasSubstr("\n  " + std::string(command.name) + " ");
    if (command.group == Group::kHidden) {
      EXPECT_THAT(help, ::testing::Not(row));
    } else {
      EXPECT_THAT(help, row);
    }
  }
  for (const auto& [group, title] : kGroups) EXPECT_THAT(help, HasSubstr(title));
}

TEST_F(Help, fits_the_width) {
  for (const int width : {40, 60, 80, 100}) {
    EXPECT_LE(longest_line(program_help(program_command(), commands_, width)), width);
    for (const Subcommand& command : commands_) {
      EXPECT_LE(longest_line(command_help(command, width)), width) << command.name;
    }
  }
}

TEST_F(Help, is_as_wide_as_the_terminal_but_never_above_100_columns) {
  EXPECT_EQ(lumaknot({"mesh", "--help"}).log, command_help(mesh_command(), 80));
  EXPECT_EQ(lumaknot_at("60", {"mesh", "--help"}).log, command_help(mesh_command(), 60));
  EXPECT_EQ(lumaknot_at("wide", {"mesh", "--help"}).log, command_help(mesh_command(), 80));
  EXPECT_LE(longest_line(lumaknot_at("250", {"--help"}).log), 100u);
  for (const Subcommand& command : commands_) {
    const ProcessResult result = lumaknot_at("250", {std::string(command.name), "--help"});
    EXPECT_LE(longest_line(result.log), 100u) << result.log;
  }
}

TEST_F(Help, shows_choices_ranges_defaults_and_dependencies) {
  const std::string render = one_line(command_help(render_command(), 100));
  EXPECT_THAT(
      render,
      AllOf(HasSubstr("-o, --output FILE"), HasSubstr("(16 bits) [required]"),
            HasSubstr("Texture filter [bilinear, trilinear; default: bilinear; needs --fast]"),
            HasSubstr("[0 to 1024; default: 0; needs --fast]"), HasSubstr("--truth [MODE]"),
            HasSubstr("not with --fast]")));
  EXPECT_THAT(command_help(bench_command(), 100), HasSubstr("--samples N,..."));
  EXPECT_THAT(one_line(command_help(mesh_command(), 100)), HasSubstr("[above 0; default: 0.18]"));
}

TEST_F(Help, lists_the_files_that_are_written) {
  const std::string mesh = one_line(command_help(mesh_command(), 100));
  EXPECT_THAT(mesh, AllOf(HasSubstr("Mesh file to write: .obj, .ply, .stl, .off, .om, .glb, .gltf "
                                    "or .inc (POV-Ray)"),
                          HasSubstr("Write .ply and .stl as text"),
                          HasSubstr("Keep quads (.obj, .ply, .off)"),
                          HasSubstr("Add tangents for normal mapping (.glb, .gltf)")));
  EXPECT_THAT(one_line(command_help(export_command(), 100)),
              HasSubstr("File to write: .pov, .py (Blender script), .blend, .glb, .gltf or .obj"));
}

TEST_F(Help, examples_are_parsed) {
  std::vector<Subcommand> all = commands_;
  all.push_back(program_command());
  for (const Subcommand& command : all) {
    EXPECT_FALSE(command.examples.empty()) << command.name;
    for (const Example& example : command.examples) {
      const std::vector<Subcommand> fresh = all_commands();
      const Parsed parsed = parse(fresh, arguments_of(example.line));
      EXPECT_EQ(parsed.request, Parsed::Request::kRun) << example.line;
      ASSERT_TRUE(parsed.command) << example.line;
      if (command.name.empty()) continue;
      EXPECT_EQ(parsed.command->name, command.name) << example.line;
    }
  }
}

TEST_F(Help, an_unknown_flag_of_any_command_is_refused_in_one_line) {
  for (const Subcommand& command : commands_) {
    std::vector<std::string> arguments{std::string(command.name), "--no-such-flag"};
    for (const Argument& argument : command.arguments) {  // missing arguments are reported first
      if (!argument.required) continue;
      if (!is_positional(argument)) arguments.push_back(names_of(argument).front());
      arguments.push_back(argument.choices.empty() ? "out" : argument.choices.front());
    }
    expect_refused(arguments, "--no-such-flag");
  }
  EXPECT_THAT(files(), ::testing::IsEmpty());
}

TEST_F(Help, every_command_has_a_reproducible_manual_page) {
  ASSERT_THAT(lumaknot({"man", "-o", "one"}), ExitsWith(0));
  ASSERT_THAT(lumaknot({"man", "-o", "two"}), ExitsWith(0));
  std::vector<std::string> expected{"lumaknot.1"}, pages;
  for (const Subcommand& command : commands_) {
    if (command.group == Group::kHidden) continue;
    expected.push_back("lumaknot-" + std::string(command.name) + ".1");
    EXPECT_THAT(read("one/lumaknot.1"), HasSubstr("lumaknot\\-" + std::string(command.name)));
  }
  for (const auto& entry : fs::directory_iterator(path("one"))) {
    pages.push_back(entry.path().filename().string());
    const std::string page = read("one/" + pages.back());
    EXPECT_EQ(page, read("two/" + pages.back()));
    EXPECT_EQ(page.find(folder_.path().string()), std::string::npos) << "a path of this machine";
  }
  std::ranges::sort(expected);
  std::ranges::sort(pages);
  EXPECT_EQ(pages, expected);
}

TEST_F(Help, man_finds_no_fault_with_the_pages) {
  const fs::path man = find_program("man");
  ASSERT_FALSE(man.empty()) << "install with apt-get install man-db";
  ASSERT_THAT(lumaknot({"man", "-o", "pages"}), ExitsWith(0));
  for (const auto& entry : fs::directory_iterator(path("pages"))) {
    const ProcessResult result = run_here({man.string(), "--warnings", "-l", entry.path().string()},
                                          {"MANWIDTH=80", "MANPAGER=cat"});
    EXPECT_THAT(result, ExitsWith(0));
    EXPECT_THAT(result.log, AllOf(HasSubstr("SYNOPSIS"), HasSubstr("EXAMPLES"),
                                  ::testing::Not(HasSubstr("warning"))));
  }
}

}  // namespace
}  // namespace lumaknot::cli
