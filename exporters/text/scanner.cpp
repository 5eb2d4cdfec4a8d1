#include "exporters/text/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace lumaknot {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

/// from_chars does not accept a leading plus.
std::string_view without_plus(std::string_view word) {
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return has_plus ? word.substr(1) : word;
}

}  // namespace

Error file_error(std::string_view name, std::string_view unit, std::uint64_t place,
                 std::string_view what) {
  return Error(fmt::format("{}, {} {}: {}", name, unit, place, what));
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kMax = 24;
  std::string text(word.substr(0, kMax));
  std::ranges::replace_if(text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return word.size() > kMax ? text + "..." : text;
}

std::optional<double> number_of(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return {};
  if (error == std::errc::result_out_of_range) {
    const bool is_tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
    return is_tiny ? 0 : std::numeric_limits<double>::infinity();
  }
  return value;
}

std::optional<std::int64_t> integer_of(std::string_view word) {
  using Limits = std::numeric_limits<std::int64_t>;
  word = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return {};
  if (error == std::errc::result_out_of_range)
    return word[0] == '-' ? Limits::min() : Limits::max();
  return value;
}

bool is_usable(double value) {
  return std::abs(value) <= double(std::numeric_limits<float>::max());
}

TextScanner::TextScanner(std::string_view text, std::string_view name, std::uint64_t first_line)
    : text_(text), name_(name), line_(first_line) {
  const std::size_t zero = text.find('\0');
  if (zero == text.npos) return;
  line_ += std::uint64_t(std::count(text.begin(), text.begin() + std::ptrdiff_t(zero), '\n'));
  fail("a zero byte, so this is not text; is the file's extension right?");
}

bool TextScanner::continues_at(std::size_t at) const {
  const std::string_view rest = text_.substr(at, 3);
  return rest.starts_with("\\\n") || rest == "\\\r\n";
}

void TextScanner::skip_blanks() {
  while (at_ < text_.size()) {
    if (is_blank(text_[at_])) {
      ++at_;
    } else if (text_[at_] == '\\' && continues_at(at_)) {
      at_ = text_.find('\n', at_) + 1;
      ++line_;
    } else {
      return;
    }
  }
}

std::string_view TextScanner::word() {
  skip_blanks();
  const std::size_t begin = at_;
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (is_blank(c) || c == '\n' || c == '#' || (c == '\\' && continues_at(at_))) break;
    ++at_;
  }
  return text_.substr(begin, at_ - begin);
}

bool TextScanner::next_line() {
  // Before the first line there is no word to skip.
  if (at_ > 0) at_ = std::min(text_.find('\n', at_), text_.size());
  for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
    if (text_[at_] == '#') at_ = std::min(text_.find('\n', at_), text_.size());
    if (at_ == text_.size()) return false;
    if (text_[at_] != '\n') return true;
    ++at_;
    ++line_;
  }
  return false;
}

double TextScanner::number() {
  const std::string_view text = word();
  if (text.empty()) fail(fmt::format("a number is missing here; {}", kExportAgain));
  const auto value = number_of(text);
  if (!value) fail(fmt::format("{} is not a number; {}", in_quotes(text), kExportAgain));
  if (!is_usable(*value)) {
    fail(fmt::format("{} is not a finite float32 number; {}", in_quotes(text), kExportAgain));
  }
  return *value;
}

std::uint64_t TextScanner::count() {
  const std::string_view text = word();
  if (text.empty()) fail(fmt::format("a count is missing here; {}", kExportAgain));
  const auto value = integer_of(text);
  if (!value || *value < 0) {
    fail(fmt::format("{} is not a count; {}", in_quotes(text), kExportAgain));
  }
  return std::uint64_t(*value);
}

void TextScanner::fail(std::string_view what) const {
  throw file_error(name_, "line", line_, what);
}

}  // namespace lumaknot
