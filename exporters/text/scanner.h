/// The words of a text file, line by line, for readers that report the place of an error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "system/error.h"

namespace lumaknot {

/// The remedy for a mesh file with an error.
inline constexpr std::string_view kExportAgain = "export the mesh again";

/// The error of a file called `name` at `place`, counted in `unit` ("line").
Error file_error(std::string_view name, std::string_view unit, std::uint64_t place,
                 std::string_view what);

/// `word` for a message: truncated when long, with "?" for unprintable characters.
std::string in_quotes(std::string_view word);

/// The number spelled by all of `word`, whatever the locale, including nan and inf. Beyond double's
/// range it is infinite or zero.
std::optional<double> number_of(std::string_view word);

/// The integer spelled by all of `word`. Beyond 64 bits it is the nearest that fits.
std::optional<std::int64_t> integer_of(std::string_view word);

/// Whether readers accept `value`: finite and within float32's range, so that areas and lengths
/// stay within double's.
bool is_usable(double value);

/// Iterates over lines and the words in them. A line ends at \n; a backslash before it
/// continues the line; # begins a comment.
class TextScanner {
 public:
  /// `text` is kept as a view. Its first line has the number `first_line`. Throws Error, calling
  /// the file `name`, when it contains a zero byte.
  TextScanner(std::string_view text, std::string_view name, std::uint64_t first_line = 1);

  /// Goes to the next line that has a word, initially to the first. False if there is none.
  bool next_line();
  /// The next word of this line, empty at its end.
  std::string_view word();
  /// The next word of this line as a number. Throws Error unless it is_usable().
  double number();
  /// The next word of this line as a count. Throws Error for a sign or a fraction.
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
