/// What a scene's numbers must satisfy, told so that the reader knows what to change.
#pragma once

#include <string>

#include "scene/fields.h"
#include "scene/scene.h"

namespace lumaknot {

/// Throws Error unless `value` lies in `range`; `label` is the JSON path or the flag.
void check_integer(const std::string& label, long long value, IntRange range);

/// Throws Error unless `value` is finite and within `bound`.
void check_number(const std::string& label, double value, Bound bound);

/// What errors call the field `key`: `prefix` + key ("mesh.knot.p"), or, after "--", the flag.
std::string field_label(const std::string& prefix, std::string_view key);

/// Throws Error unless every field of `knot` is in its range, the convention can have them and the
/// mesh is of a size that can be built. Fields are called by field_label().
void check_knot(const KnotSpec& knot, const std::string& prefix);

/// Throws Error for what no single field can tell: a line of sight without a direction, a luma
/// offset outside a luma space, an image too large. Fields are called by their JSON path.
void check_scene(const SceneSpec& spec);

/// Throws Error when `image` holds more than `limit` samples in all, counted in 64 bits.
void check_samples(const ImageSpec& image, long long limit);

}  // namespace lumaknot
