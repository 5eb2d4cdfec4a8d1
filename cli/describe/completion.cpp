#include "cli/describe/completion.h"

namespace lumaknot::cli {

std::string brief(const Argument& argument) {
  return argument.meaning.substr(0, argument.meaning.find(';'));
}

std::string single_quoted(std::string_view text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

}  // namespace lumaknot::cli
