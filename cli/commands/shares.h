/// Numbers and shares as the values of flags.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lumaknot::cli {

/// The number that is the whole of `text`; empty if it isn't one.
std::optional<double> number_of(std::string_view text);

/// A share in [0, 1], as a number or in per cent: "0.99" or "99%". Throws Error, naming `flag`, for
/// all else.
double share_of(std::string_view flag, const std::string& text);

}  // namespace lumaknot::cli
