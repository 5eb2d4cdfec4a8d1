/// Geomview OFF, as text.
#pragma once

#include "exporters/mesh/format.h"

namespace lumaknot {

/// Also with normals (NOFF), texture coordinates (STOFF) and colours (COFF), which are skipped.
Polygons read_off(std::string_view bytes, std::string_view name);

/// Without normals and texture coordinates, which every reader accepts. Each position once; uses 10
/// more bytes per vertex.
void write_off(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

}  // namespace lumaknot
