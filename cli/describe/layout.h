/// Lays out text in lines of a given width.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lumaknot::cli {

/// `words` separated by `divider`.
std::string joined(const std::vector<std::string>& words, std::string_view divider);

/// `text` in lines of at most `width` characters, broken at spaces and newlines. A longer word gets
/// its own line.
std::vector<std::string> wrapped(std::string_view text, int width);

/// `text` wrapped, each line indented by `indent` and ending in a newline.
std::string paragraph(std::string_view text, int indent, int width);

/// `left`, indented by two, and `right` wrapped from column `at` on; below `left` if that is too
/// long.
std::string row(const std::string& left, std::string_view right, int at, int width);

/// A command line, indented by two and continued by backslashes.
std::string command_line(std::string_view line, int width);

/// The width from the environment's COLUMNS or the terminal, at most 100; 80 if unknown.
int help_width();

}  // namespace lumaknot::cli
