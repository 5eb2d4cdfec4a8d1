/// A recorded formula as Blender shader nodes.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shaders/graph/expression.h"

namespace lumaknot {

/// Whether the scene's numbers are separate nodes, or read by name from a group's inputs.
enum class ParameterNodes { kValues, kInputs };

/// The nodes that compute `root`, in dependency order, as read by
/// exporters/blender/lumaknot_nodes.py: {"nodes": [...], "output": index of the last}. Sockets are
/// named by identifier, which no language setting changes.
nlohmann::ordered_json blender_nodes(const NodePtr& root,
                                     ParameterNodes parameters = ParameterNodes::kValues);

}  // namespace lumaknot
