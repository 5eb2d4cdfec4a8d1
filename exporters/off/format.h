/// Geomview OFF, as text.
#pragma once

#include "exporters/mesh/format.h"

namespace lumaknot::off {

/// Also with normals (NOFF), texture coordinates (STOFF) and colours (COFF), which are skipped.
Polygons read(std::string_view bytes, std::string_view name);

/// Without normals and texture coordinates, which every reader accepts. Each position once; uses 10
/// more bytes per vertex.
void write(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

}  // namespace lumaknot::off
