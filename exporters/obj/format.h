/// Wavefront OBJ.
#pragma once

#include "exporters/mesh/format.h"

namespace lumaknot::obj {

/// v, vt, vn and f; points, lines and groups are skipped.
Polygons read(std::string_view bytes, std::string_view name);

/// v, vt, vn, f with separate indices, each position once, so that readers see a closed surface.
/// Uses 10 more bytes per vertex.
void write(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

}  // namespace lumaknot::obj
