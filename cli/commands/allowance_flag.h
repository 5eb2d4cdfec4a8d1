/// The flag --allow: which known differences a user accepts.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "validate/compare/allowances.h"

namespace lumaknot::cli {

/// --allow CLASS=SHARE,...; checked by allowances_of().
Argument allow_argument(std::vector<std::string>& values);

/// The shares of values such as "turned-normal=20%" and "all=0.2"; the last of a class counts.
/// Throws Error for a class that is not known and a share outside [0, 1].
validate::Allowances allowances_of(const std::vector<std::string>& values);

}  // namespace lumaknot::cli
