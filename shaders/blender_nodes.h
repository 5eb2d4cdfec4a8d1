/// A recorded formula as Blender shader nodes.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shaders/expression.h"

namespace lumaknot {

/// The nodes that compute `root`, in dependency order, as exporters/blender_scene.py reads them:
/// {"nodes": [...], "output": index of the last}. Sockets are named by identifier, which no
/// language setting changes.
nlohmann::ordered_json blender_nodes(const NodePtr& root);

}  // namespace lumaknot
