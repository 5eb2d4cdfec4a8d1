// Lexical structure: POV-Ray 3.7's manual, section 2.2.1.
#include "exporters/povray/tokens.h"

#include <fmt/format.h>

#include <algorithm>

#include "exporters/text/scanner.h"

namespace lumaknot::povray {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

}  // namespace

std::string_view PovTokens::next() {
  skip_blanks();
  const std::size_t begin = at_;
  if (at_ == text_.size()) return {};
  if (text_[at_] == '"') {
    pass_string();
  } else if (is_letter(text_[at_])) {
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
  } else if (begins_number()) {
    pass_number();
  } else {
    ++at_;
  }
  return text_.substr(begin, at_ - begin);
}

std::string_view PovTokens::peek() {
  const PovTokens before = *this;
  const std::string_view token = next();
  *this = before;
  return token;
}

void PovTokens::fail(std::string_view what) const { throw file_error(name_, "line", line_, what); }

void PovTokens::step() {
  if (text_[at_] == '\n') ++line_;
  ++at_;
}

void PovTokens::skip_blanks() {
  while (at_ < text_.size()) {
    if (text_.substr(at_).starts_with("//")) {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (text_.substr(at_).starts_with("/*")) {
      pass_comment();
    } else if (std::string_view(" \t\r\n\f\v").find(text_[at_]) != std::string_view::npos) {
      step();
    } else {
      return;
    }
  }
}

/// Comments nest.
void PovTokens::pass_comment() {
  const std::uint64_t begin = line_;
  int depth = 0;
  do {
    if (at_ == text_.size()) {
      fail(fmt::format("the comment of line {} does not end; {}", begin, kExportAgain));
    }
    const bool opens = at(0) == '/' && at(1) == '*', closes = at(0) == '*' && at(1) == '/';
    depth += int(opens) - int(closes);
    if (opens || closes) ++at_;
    step();
  } while (depth > 0);
}

void PovTokens::pass_string() {
  for (++at_; at(0) != '"'; step()) {
    if (at_ == text_.size()) fail(fmt::format("a string that does not end; {}", kExportAgain));
    if (at(0) == '\\' && at_ + 1 < text_.size()) ++at_;
  }
  ++at_;
}

bool PovTokens::begins_number() const {
  const std::size_t sign = at(0) == '-' || at(0) == '+';
  return is_digit(at(sign)) || (at(sign) == '.' && is_digit(at(sign + 1)));
}

void PovTokens::pass_number() {
  ++at_;
  while (is_digit(at(0)) || at(0) == '.') ++at_;
  const std::size_t sign = at(1) == '-' || at(1) == '+';
  if ((at(0) != 'e' && at(0) != 'E') || !is_digit(at(1 + sign))) return;
  at_ += 1 + sign;
  while (is_digit(at(0))) ++at_;
}

}  // namespace lumaknot::povray
