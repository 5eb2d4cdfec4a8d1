/// The flags --limit and --limits: errors that a user accepts in place of the derived limits.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/command.h"
#include "validate/renderers/limits.h"

namespace lumaknot::cli {

/// The values of both flags.
struct LimitFlags {
  std::vector<std::string> values;  ///< of --limit
  std::string file;                 ///< of --limits
};

/// --limit KEY=X,... and --limits FILE; checked by limits_of().
std::vector<Argument> limit_arguments(LimitFlags& flags);

/// The limits by the renderers' flags: those of the file, and for what they leave open those of
/// --limit. Throws Error for keys and renderers that are not known and values outside [0, 1].
std::map<std::string, validate::Limits, std::less<>> limits_of(const LimitFlags& flags);

}  // namespace lumaknot::cli
