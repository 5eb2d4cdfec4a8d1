/// What a command says while it works.
#pragma once

#include <functional>
#include <string>

namespace lumaknot {

/// What --quiet and --json ask for.
struct Output {
  bool quiet = false;  ///< say nothing but errors
  bool json = false;   ///< the result as JSON on standard output

  /// Prints a line about the result, unless quiet or reported as JSON.
  void say(const std::string& line) const;
};

/// A progress bar on standard error for work that has lasted a second; nothing when standard error
/// is not a terminal or `output` is quiet. Call with the finished share in [0, 1].
std::function<void(double)> progress_bar(const Output& output, std::string label);

}  // namespace lumaknot
