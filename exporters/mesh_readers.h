/// The mesh formats that read_mesh() knows, one function each, and what they share.
#pragma once

#include <string_view>

#include "exporters/polygons.h"

namespace lumaknot {

// Each reads the bytes of a whole file. They throw Error, calling the file `name` and telling the
// line or byte, for what is no such file, is cut short, counts more than the file can hold, holds
// numbers that are not finite, or names vertices that are not there.

/// Wavefront OBJ: v, vt, vn and f; points, lines and groups are passed over.
Polygons read_obj(std::string_view bytes, std::string_view name);

/// Stanford PLY, as text or binary of either byte order. Texture coordinates are the vertices' s,
/// t; u, v or texture_u, texture_v, or the faces' list texcoord.
Polygons read_ply(std::string_view bytes, std::string_view name);

/// STL, as text or binary. Equal positions are one; each facet's normal is its corners'.
Polygons read_stl(std::string_view bytes, std::string_view name);

/// Geomview OFF as text, also with normals (NOFF), texture coordinates (STOFF) and colours (COFF),
/// which are passed over.
Polygons read_off(std::string_view bytes, std::string_view name);

/// OpenMesh's OM, versions 2.0 to 2.2.
Polygons read_om(std::string_view bytes, std::string_view name);

/// The mesh2 objects of a POV-Ray scene, written in numbers. Textures are passed over.
Polygons read_pov(std::string_view bytes, std::string_view name);

/// Throws Error unless every corner's indices are within `polygons`.
void check_indices(const Polygons& polygons, std::string_view name);

}  // namespace lumaknot
