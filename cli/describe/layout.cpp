#include "cli/describe/layout.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace lumaknot::cli {
namespace {

constexpr int kMinWidth = 40, kMaxWidth = 100, kDefaultWidth = 80;

/// Appends the wrapped lines of `text`, which has no newlines.
void wrap_line(std::string_view text, std::size_t width, std::vector<std::string>& lines) {
  lines.emplace_back();
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (lines.back().size() + 1 + word.size() > width && !lines.back().empty()) {
      lines.emplace_back();
    }
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
  }
}

/// From COLUMNS, else from the terminal on standard output; 0 if neither is known.
int columns() {
  const char* text = std::getenv("COLUMNS");
  if (const int given = text ? std::atoi(text) : 0; given > 0) return given;
  winsize size{};
  if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

}  // namespace

std::string joined(const std::vector<std::string>& words, std::string_view divider) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += divider;
    text += word;
  }
  return text;
}

std::vector<std::string> wrapped(std::string_view text, int width) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    wrap_line(text.substr(start, end - start), std::size_t(width), lines);
    start = end + 1;
  }
  return lines;
}

std::string paragraph(std::string_view text, int indent, int width) {
  std::string all;
  for (const std::string& line : wrapped(text, width - indent)) {
    all += std::string(std::size_t(indent), ' ') + line + "\n";
  }
  return all;
}

std::string row(const std::string& left, std::string_view right, int at, int width) {
  if (right.empty()) return "  " + left + "\n";
  const std::string body = paragraph(right, at, width);
  if (2 + int(left.size()) + 2 > at) return "  " + left + "\n" + body;
  return "  " + left + body.substr(2 + left.size());
}

std::string command_line(std::string_view line, int width) {
  std::string all;
  for (const std::string& part : wrapped(line, width - 8)) {
    all += (all.empty() ? "  " : " \\\n      ") + part;
  }
  return all + "\n";
}

int help_width() {
  const int known = columns();
  return known == 0 ? kDefaultWidth : std::clamp(known, kMinWidth, kMaxWidth);
}

}  // namespace lumaknot::cli
