/// Shell completion of commands, flags and values.
#pragma once

#include <span>
#include <string>

#include "cli/command.h"

namespace lumaknot::cli {

/// A script for bash, to be sourced.
std::string bash_completion(const Subcommand& program, std::span<const Subcommand> commands);

/// A function for zsh, to be sourced or put in a folder of $fpath as _lumaknot.
std::string zsh_completion(const Subcommand& program, std::span<const Subcommand> commands);

/// A script for fish, to be sourced or put in a folder of completions as lumaknot.fish.
std::string fish_completion(const Subcommand& program, std::span<const Subcommand> commands);

/// The meaning up to its first semicolon, for lists of candidates.
std::string brief(const Argument& argument);

/// `text` in single quotes for bash, zsh and fish.
std::string single_quoted(std::string_view text);

}  // namespace lumaknot::cli
