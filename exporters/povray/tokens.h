/// The words, numbers and punctuation of POV-Ray's language.
#pragma once

#include <cstdint>
#include <string_view>

#include "exporters/text/scanner.h"

namespace lumaknot::povray {

/// A text's tokens, without its comments.
class PovTokens {
 public:
  /// Keeps both by reference; `name` is the file's, for errors.
  PovTokens(std::string_view text, std::string_view name) : text_(text), name_(name) {}

  /// The next token, empty at the text's end. Strings keep their quotation marks. Throws Error for
  /// strings and comments that don't end.
  std::string_view next();

  std::string_view peek();

  /// The line of the next token, from 1.
  std::uint64_t line() const { return line_; }

  /// The remaining bytes.
  std::size_t remaining() const { return text_.size() - at_; }

  /// Throws Error with the file's name and the line.
  [[noreturn]] void fail(std::string_view what) const;

 private:
  char at(std::size_t ahead) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  bool begins_number() const;
  void step();
  void skip_blanks();
  void pass_comment();
  void pass_string();
  void pass_number();

  std::string_view text_, name_;
  std::size_t at_ = 0;
  std::uint64_t line_ = 1;
};

}  // namespace lumaknot::povray
