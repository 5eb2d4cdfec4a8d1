/// STL.
#pragma once

#include "exporters/mesh/format.h"

namespace lumaknot::stl {

/// As text or binary. Equal positions are merged; each facet's normal is its corners'.
Polygons read(std::string_view bytes, std::string_view name);

/// Little-endian or text, with the facets' own normals; zero where a facet has no area.
void write(std::ostream& stream, const TriangleMesh& mesh, const MeshFileOptions& options);

}  // namespace lumaknot::stl
