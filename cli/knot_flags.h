/// The knot of the command line.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "cli/command.h"

namespace lumaknot {

/// A flag for every field of a knot. What is given is gathered in `given`, an object, to be read
/// and checked by knot_from_json().
std::vector<Argument> knot_arguments(std::shared_ptr<nlohmann::ordered_json> given);

}  // namespace lumaknot
