/// The flags that describe a knot.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "cli/command.h"

namespace lumaknot::cli {

/// A flag for every field of a knot. The values given are collected in the object `given`, which
/// knot_from_json() reads and checks.
std::vector<Argument> knot_arguments(std::shared_ptr<nlohmann::ordered_json> given);

}  // namespace lumaknot::cli
