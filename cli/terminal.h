/// What a command says while it works.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace lumaknot {

/// The flags that every working command shares.
struct Output {
  bool quiet = false;  ///< say nothing but errors
  bool json = false;   ///< the result as JSON on standard output

  /// Prints a line about the result, unless quiet or told in JSON.
  void say(const std::string& line) const;
};

/// Adds --quiet and --json to `command`.
void add_output_flags(CLI::App& command, Output& output);

/// A progress bar on standard error for work that has lasted a second; nothing when standard error
/// is not a terminal or `output` is quiet. Call with the finished share in [0, 1].
std::function<void(double)> progress_bar(const Output& output, std::string label);

}  // namespace lumaknot
