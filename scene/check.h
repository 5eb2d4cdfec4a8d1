/// The conditions on a scene's numbers, with errors that say what to change.
#pragma once

#include <string>

#include "scene/fields.h"
#include "scene/spec.h"

namespace lumaknot {

/// Throws Error unless `value` lies in `range`; `label` is the JSON path or the flag.
void check_integer(const std::string& label, long long value, Interval<int> range);

/// Throws Error unless `value` is finite and in `range`; `why` ends what it must be (" for
/// minnaert").
void check_number(const std::string& label, double value, Interval<double> range,
                  std::string_view why = {});

/// The name of the field `key` in errors: `prefix` + key ("mesh.knot.p"), or, after "--", the flag.
std::string field_label(const std::string& prefix, std::string_view key);

/// Throws Error unless every field of `knot` is in its range, the convention supports it and the
/// mesh is small enough to build. Fields are named by field_label().
void check_knot(const KnotSpec& knot, const std::string& prefix);

/// Throws Error for conditions on several fields: a line of sight without a direction, a luma
/// offset outside a luma space, an image too large. Fields are named by their JSON path.
void check_scene(const SceneSpec& spec);

/// Throws Error when `image` has more than `limit` samples in total, counted in 64 bits.
void check_samples(const ImageSpec& image, long long limit);

}  // namespace lumaknot
