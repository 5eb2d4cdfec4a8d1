/// The words of a text file, line by line, for readers that must say where it is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scene/error.h"

namespace lumaknot {

/// What to do about a mesh file that is wrong.
inline constexpr std::string_view kExportAgain = "export the mesh again";

/// What to throw for a file called `name` that is wrong at `place`, counted in `unit` ("line").
Error file_error(std::string_view name, std::string_view unit, std::uint64_t place,
                 std::string_view what);

/// `word` for a message: cut when long, with "?" for what does not print.
std::string in_quotes(std::string_view word);

/// The number that all of `word` spells, whatever the locale, also nan and inf. Beyond double's
/// range it is infinite or zero.
std::optional<double> number_of(std::string_view word);

/// The integer that all of `word` spells. Beyond 64 bits it is the nearest that they hold.
std::optional<std::int64_t> integer_of(std::string_view word);

/// Whether readers take `value`: finite, and within what float32 holds, so that areas and lengths
/// stay within what double holds.
bool is_usable(double value);

/// Walks through lines and the words in them. A line ends at \n; a backslash before it continues
/// the line; # begins a comment.
class TextScanner {
 public:
  /// `text` is kept as a view. Its first line has the number `first_line`. Throws Error, calling
  /// the file `name`, when it holds a zero byte.
  TextScanner(std::string_view text, std::string_view name, std::uint64_t first_line = 1);

  /// Goes to the next line that has a word, at first to the first. False when there is none.
  bool next_line();
  /// The next word of this line, empty at its end.
  std::string_view word();
  /// The next word of this line as a number. Throws Error unless it is_usable().
  double number();
  /// The next word of this line as a number of things. Throws Error for a sign or a fraction.
  std::uint64_t count();

  std::uint64_t line() const { return line_; }
  /// Bytes after the last word.
  std::size_t remaining() const { return text_.size() - at_; }
  /// Throws Error with the line.
  [[noreturn]] void fail(std::string_view what) const;

 private:
  bool continues_at(std::size_t at) const;
  void skip_blanks();

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
  std::uint64_t line_;
};

}  // namespace lumaknot
