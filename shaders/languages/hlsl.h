/// How HLSL spells formulas, shader models 2 to 6.
#pragma once

#include "shaders/languages/common.h"
#include "shaders/languages/reserved_words.h"

namespace lumaknot {

inline constexpr Helper kHlslHelpers[] = {kSafePower,
                                          {"safe_normalize",
                                           "// Zero stays zero.\n"
                                           "float3 safe_normalize(float3 v) {\n"
                                           "  return v * rsqrt(max(dot(v, v), 1e-36));\n"
                                           "}\n\n"}};

inline constexpr Dialect kHlslDialect{.scalar_type = "float",
                                      .vector_type = "float3",
                                      .uv_type = "float2",
                                      .vector_of = "float3({0}, {1}, {2})",
                                      .grey_of = "float3({0}, {0}, {0})",
                                      .component = {"{0}.x", "{0}.y", "{0}.z"},
                                      .saturate = "saturate({0})",
                                      .vector_saturate = "saturate({0})",
                                      .helpers = kHlslHelpers,
                                      .reserved = kHlslWords};

}  // namespace lumaknot
