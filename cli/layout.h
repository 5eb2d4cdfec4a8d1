/// Text in lines of a given width.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lumaknot {

/// `words` with `divider` between each two.
std::string joined(const std::vector<std::string>& words, std::string_view divider);

/// `text` in lines of at most `width` characters, broken at spaces and at newlines. A longer word
/// has a line of its own.
std::vector<std::string> wrapped(std::string_view text, int width);

/// `text` wrapped, each line indented by `indent` and ended by a newline.
std::string paragraph(std::string_view text, int indent, int width);

/// `left`, indented by two, and `right` wrapped in the column `at`; on the next line where `left`
/// is too long.
std::string row(const std::string& left, std::string_view right, int at, int width);

/// A command line that is continued by backslashes.
std::string command_line(std::string_view line, int width);

/// Columns of the terminal, or of the environment's COLUMNS, at most 100; 80 unless known.
int help_width();

}  // namespace lumaknot
