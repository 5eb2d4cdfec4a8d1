/// The message for a scene that no pixel shows.
#pragma once

namespace lumaknot::measure {

inline constexpr const char* kNothingSeen =
    "the scene covers no pixel's centre; move camera.position nearer, or turn it to camera.target";

}  // namespace lumaknot::measure
