/// The knot of the command line.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace CLI {
class App;
}

namespace lumaknot {

/// Adds a flag for every field of a knot to `command`; what is given is gathered in an object, to
/// be read by knot_from_json().
std::shared_ptr<nlohmann::ordered_json> add_knot_flags(CLI::App& command);

}  // namespace lumaknot
