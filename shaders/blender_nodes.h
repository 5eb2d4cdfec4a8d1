/// A recorded formula as Blender shader nodes.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shaders/expression.h"

namespace lumaknot {

/// Whether the numbers of the scene are nodes of their own, or read from a group's inputs by name.
enum class ParameterNodes { kValues, kInputs };

/// The nodes that compute `root`, in dependency order, as exporters/lumaknot_nodes.py reads them:
/// {"nodes": [...], "output": index of the last}. Sockets are named by identifier, which no
/// language setting changes.
nlohmann::ordered_json blender_nodes(const NodePtr& root,
                                     ParameterNodes parameters = ParameterNodes::kValues);

}  // namespace lumaknot
