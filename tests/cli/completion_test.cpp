// The completion scripts, run by the shells themselves.
#include <gmock/gmock.h>

#include <sstream>

#include "cli/command_table.h"
#include "scene/fields.h"
#include "tests/cli/program_test.h"

namespace lumaknot::cli {
namespace {

using Words = std::vector<std::string>;

/// Each driver prints, per line of the file `lines`, the candidates for its last word and "@".
constexpr const char* kBashDriver = R"(
source lumaknot.bash
while IFS= read -r line; do
  read -ra COMP_WORDS <<< "$line"
  [[ $line == *" " ]] && COMP_WORDS+=("")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _lumaknot
  ((${#COMPREPLY[@]})) && printf '%s\n' "${COMPREPLY[@]}"
  echo @
done < lines
)";

constexpr const char* kFishDriver = R"(
source lumaknot.fish
while read -l line
  complete -C "$line" | string replace -r '\t.*' ''
  echo @
end < lines
)";

/// zsh completes in a separate interactive shell: all matches are inserted into the line, and the
/// line is written to a file, without the words before the last.
constexpr const char* kZshDriver = R"(
zmodload zsh/zpty
zpty shell "TERM=dumb zsh -f -i"
zpty -w shell "source ./setup; print rea''dy"
while zpty -r shell reply; do [[ $reply == *ready* ]] && break; done
: > found
integer count=0
while IFS= read -r line; do
  zpty -n -w shell "$line"$'\C-Y\C-T'
  count+=1
  while (( $(wc -l < found) < count )); do zpty -r -t shell reply; sleep 0.02; done
  tail -n 1 found | IFS= read -r found
  [[ $found == $line ]] || print -rl -- ${(z)found#${line% *} }
  print @
done < lines
zpty -d shell
)";

constexpr const char* kZshSetup = R"(
PS1=; HISTFILE=
zle -C all complete-word _generic
bindkey '^Y' all
zstyle ':completion:all::::' completer _all_matches _complete
zstyle ':completion:all:*' insert yes
report() { print -r -- $BUFFER >> found; BUFFER= }
zle -N report
bindkey '^T' report
)";

class Completion : public Program {
 protected:
  void SetUp() override {
    write("scene-of-mine.json", "{}");
    write("picture.png", "");
    fs::create_directory(path("folder"));
    for (const std::string shell : {"bash", "zsh", "fish"}) {
      const ProcessResult result = lumaknot({"completion", shell});
      EXPECT_THAT(result, ExitsWith(0));
      write("lumaknot." + shell, result.log);
    }
  }

  /// The sorted candidates that `driver`, run by `shell`, finds for each line.
  std::vector<Words> completed(const std::string& shell, const char* driver, const Words& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    write("lines", text);
    write("driver", driver);
    const Words flags = shell == "fish" ? Words{"--no-config"} : Words{};
    Words command{find_program(shell).string()};
    command.insert(command.end(), flags.begin(), flags.end());
    command.push_back("driver");
    fs::remove(path("found"));
    const ProcessResult result = run_here(command, {});
    std::istringstream log(result.log);
    std::vector<Words> all{{}};
    for (std::string line; std::getline(log, line);) {
      if (line == "@") {
        std::ranges::sort(all.back());
        all.emplace_back();
      } else {
        while (line.ends_with('/') || line.ends_with('=') || line.ends_with(',')) line.pop_back();
        all.back().push_back(line);
      }
    }
    all.pop_back();
    EXPECT_EQ(all.size(), lines.size()) << result.log;
    return all;
  }

  /// Checks lines that complete alike in every shell.
  void expect_completes(const std::string& shell, const char* driver) {
    const std::vector<std::pair<std::string, Words>> cases{
        {"lumaknot comp", {"completion"}},
        {"lumaknot ma", {}},
        {"lumaknot mesh --conv", {"--convention"}},
        {"lumaknot mesh --convention t", {"three"}},
        {"lumaknot mesh --convention ", {kConventionNames.begin(), kConventionNames.end()}},
        {"lumaknot mesh --p ", {}},
        {"lumaknot validate --renderer c", {"cycles"}},
        {"lumaknot validate --against gl,v", {"gl,vulkan"}},
        {"lumaknot shader cielab-c", {"cielab-cook-torrance"}},
        {"lumaknot shader --lang glsl-330,hl", {"glsl-330,hlsl"}},
        {"lumaknot shader --rate v", {"vertex"}},
        {"lumaknot render figure1-b", {"figure1-back"}},
        {"lumaknot render scene-of", {"scene-of-mine.json"}},
        {"lumaknot render -o pict", {"picture.png"}},
        {"lumaknot render --output pict", {"picture.png"}},
        {"lumaknot render --truth a", {"area"}},
        {"lumaknot chart -o fol", {"folder"}},
        {"lumaknot chart -o paper --metr", {"--metric"}},
        {"lumaknot stability fren", {"frenet-inflection"}},
        {"lumaknot stability frenet-inflection phong-c", {"phong-cutoff"}},
        {"lumaknot completion z", {"zsh"}},
    };
    Words lines;
    for (const auto& [line, found] : cases) lines.push_back(line);
    const std::vector<Words> all = completed(shell, driver, lines);
    ASSERT_EQ(all.size(), cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
      Words expected = cases[i].second;
      std::ranges::sort(expected);
      EXPECT_EQ(all[i], expected) << shell << ": " << lines[i];
    }
  }

  /// Checks every choice of every flag of every command.
  void expect_knows_every_choice(const std::string& shell, const char* driver) {
    Words lines;
    std::vector<Words> expected;
    for (const Subcommand& command : all_commands()) {
      if (command.group == Group::kHidden) continue;
      for (const Argument& argument : command.arguments) {
        if (is_positional(argument) || argument.choices.empty() || argument.value == kScene)
          continue;
        for (const std::string& name : names_of(argument)) {
          lines.push_back("lumaknot " + std::string(command.name) + " " + name + " ");
          expected.push_back(argument.choices);
          std::ranges::sort(expected.back());
        }
      }
    }
    EXPECT_GT(lines.size(), 10u);
    EXPECT_EQ(completed(shell, driver, lines), expected);
  }
};

TEST_F(Completion, bash_completes_commands_flags_and_values) {
  expect_completes("bash", kBashDriver);
  expect_knows_every_choice("bash", kBashDriver);
}

TEST_F(Completion, bash_completes_a_value_after_an_equals_sign) {  // which is a separate word
  const std::vector<Words> all = completed(
      "bash", kBashDriver, {"lumaknot mesh --convention = t", "lumaknot mesh --unwrap ="});
  EXPECT_EQ(all, (std::vector<Words>{{"three"}, {"arc-length", "parameter"}}));
}

TEST_F(Completion, bash_omits_what_a_list_already_holds) {
  const std::vector<Words> all =
      completed("bash", kBashDriver, {"lumaknot chart --space yiq,cielab,yi"});
  EXPECT_EQ(all, (std::vector<Words>{{}}));
}

TEST_F(Completion, fish_completes_commands_flags_and_values) {
  ASSERT_FALSE(find_program("fish").empty()) << "install with apt-get install fish";
  expect_completes("fish", kFishDriver);
  expect_knows_every_choice("fish", kFishDriver);
}

TEST_F(Completion, zsh_completes_commands_flags_and_values_when_sourced) {
  ASSERT_FALSE(find_program("zsh").empty()) << "install with apt-get install zsh";
  write("setup",
        "autoload -Uz compinit; compinit -u -D\nsource ./lumaknot.zsh" + std::string(kZshSetup));
  expect_completes("zsh", kZshDriver);
}

TEST_F(Completion, zsh_finds_the_script_in_fpath) {
  ASSERT_FALSE(find_program("zsh").empty()) << "install with apt-get install zsh";
  fs::rename(path("lumaknot.zsh"), path("folder/_lumaknot"));
  write("setup", "fpath=($PWD/folder $fpath); autoload -Uz compinit; compinit -u -D" +
                     std::string(kZshSetup));
  expect_completes("zsh", kZshDriver);
}

}  // namespace
}  // namespace lumaknot::cli
