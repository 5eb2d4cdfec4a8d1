/// A command as plain data, from which its parser, help, man page and completion are built.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/fields.h"

namespace lumaknot::cli {

/// Receives a value given on the command line.
template <class T>
using Take = std::function<void(const T&)>;

/// Where an argument's values go. A bool belongs to a flag without a value.
using Target = std::variant<bool*, int*, double*, std::optional<double>*, std::string*,
                            std::vector<int>*, std::vector<std::string>*, Take<int>,
                            Take<long long>, Take<double>, Take<std::string>>;

/// Placeholders for values that shells can complete.
inline constexpr std::string_view kFile = "FILE", kFolder = "FOLDER", kProgram = "PROGRAM",
                                  kScene = "SCENE";

/// A flag with or without a value, or a positional argument.
struct Argument {
  std::string names;  ///< "-o,--output"; a positional argument's name has no dashes
  Target target = static_cast<bool*>(nullptr);
  std::string meaning = {};       ///< one phrase, without a full stop
  std::string_view value = {};    ///< placeholder; empty: from the target's type
  std::string default_text = {};  ///< empty: the target's value
  std::vector<std::string> choices = {};
  std::optional<Interval<double>> range = {};
  bool checked = true;  ///< false: the command itself checks `choices` and `range`
  bool required = false;
  bool list = false;                       ///< comma-separated values
  bool greedy = false;                     ///< values may also be separate words
  std::string_view when_alone = {};        ///< the value of a flag given without one
  std::string_view needs = {};             ///< a flag that must also be given
  std::vector<std::string> excludes = {};  ///< flags that must not be given
  std::string_view heading = "Options";    ///< of the help section
};

/// What a command is for: the sections of `lumaknot --help`, which leaves out kHidden.
enum class Group { kMake, kDraw, kProve, kStudy, kSetUp, kHidden };

/// A working command line and an optional remark.
struct Example {
  std::string_view line;
  std::string_view meaning = {};
};

struct Subcommand {
  std::string_view name = {};  ///< empty: the program itself
  Group group = Group::kMake;
  std::string_view about = {};  ///< one sentence, without a full stop
  std::vector<Argument> arguments = {};
  std::string_view notes = {};  ///< sentences
  std::vector<Example> examples = {};
  std::function<int()> run = {};  ///< after parsing; returns the exit code
};

/// Appends `more` to `arguments`.
void append(std::vector<Argument>& arguments, std::vector<Argument> more);

bool is_positional(const Argument& argument);
bool takes_value(const Argument& argument);

/// Whether it may be given several times, or as several words if it is positional.
bool is_repeatable(const Argument& argument);

/// The separate names: {"-o", "--output"}.
std::vector<std::string> names_of(const Argument& argument);

/// The placeholder of the value in help: "FILE", "NAME", "N".
std::string placeholder(const Argument& argument);

/// The value when the argument is not given; empty if none is worth showing.
std::string default_of(const Argument& argument);

/// How a shell completes a value.
enum class Completion { kNone, kWords, kList, kFiles, kFolders, kPrograms, kScenes };
Completion completion_of(const Argument& argument);

}  // namespace lumaknot::cli
