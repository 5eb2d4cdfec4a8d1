/// The mesh formats that read_mesh() supports, one function each, and a common check.
#pragma once

#include <string_view>

#include "exporters/mesh/polygons.h"

namespace lumaknot {

// Each reads the bytes of a whole file. They throw Error, calling the file `name` and giving the
// line or byte, for a file that is not of its format, is cut short, counts more than it can hold,
// has numbers that are not finite, or refers to missing vertices.

/// Wavefront OBJ: v, vt, vn and f; points, lines and groups are skipped.
Polygons read_obj(std::string_view bytes, std::string_view name);

/// Stanford PLY, as text or binary of either byte order. Texture coordinates are the vertices' s,
/// t; u, v or texture_u, texture_v, or the faces' list texcoord.
Polygons read_ply(std::string_view bytes, std::string_view name);

/// STL, as text or binary. Equal positions are merged; each facet's normal is its corners'.
Polygons read_stl(std::string_view bytes, std::string_view name);

/// Geomview OFF as text, also with normals (NOFF), texture coordinates (STOFF) and colours (COFF),
/// which are skipped.
Polygons read_off(std::string_view bytes, std::string_view name);

/// OpenMesh's OM, versions 2.0 to 2.2.
Polygons read_om(std::string_view bytes, std::string_view name);

/// The mesh2 objects of a POV-Ray scene, given in plain numbers. Textures are skipped.
Polygons read_pov(std::string_view bytes, std::string_view name);

/// Throws Error unless every corner's indices are within `polygons`.
void check_indices(const Polygons& polygons, std::string_view name);

}  // namespace lumaknot
