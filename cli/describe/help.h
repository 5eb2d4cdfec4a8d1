/// The help of the program and its commands.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.h"

namespace lumaknot::cli {

/// `lumaknot --help`: the commands by purpose, in lines of at most `width` characters.
std::string program_help(const Subcommand& program, std::span<const Subcommand> commands,
                         int width);

/// `lumaknot COMMAND --help`, likewise.
std::string command_help(const Subcommand& command, int width);

// Shared by the help and the manual pages:

/// "lumaknot mesh [OPTIONS]", followed by required flags and positional arguments.
std::string usage(const Subcommand& command);

/// "-o, --output FILE"
std::string label(const Argument& argument);

/// The meaning, capitalized, and in brackets choices, range, default and other facts.
std::string explained(const Argument& argument);

/// The flags under their headings, including --help, and the positional arguments under
/// "Arguments".
using Section = std::pair<std::string_view, std::vector<Argument>>;
std::vector<Section> sections(const Subcommand& command);

/// The sections of `lumaknot --help`.
struct GroupTitle {
  Group group;
  std::string_view title;
};
inline constexpr GroupTitle kGroups[] = {{Group::kMake, "Make scenes, meshes and shaders"},
                                         {Group::kDraw, "Draw pictures"},
                                         {Group::kProve, "Prove that pictures are right"},
                                         {Group::kStudy, "Study methods and the paper"},
                                         {Group::kSetUp, "Set up"}};

}  // namespace lumaknot::cli
