/// Terminal output of a command.
#pragma once

#include <functional>
#include <string>

namespace lumaknot::cli {

/// The settings of --quiet and --json.
struct Output {
  bool quiet = false;  ///< print only errors
  bool json = false;   ///< print the result as JSON

  /// Prints a line about the result, unless quiet or in JSON mode.
  void say(const std::string& line) const;
};

/// A progress bar on standard error, shown after a second of work; empty if standard error is not a
/// terminal or `output` is quiet. Call it with the finished share in [0, 1].
std::function<void(double)> progress_bar(const Output& output, std::string label);

}  // namespace lumaknot::cli
