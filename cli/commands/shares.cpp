#include "cli/commands/shares.h"

#include <fmt/format.h>

#include <charconv>

#include "system/error.h"

namespace lumaknot::cli {

std::optional<double> number_of(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

double share_of(std::string_view flag, const std::string& text) {
  const bool per_cent = text.ends_with('%');
  const auto number = number_of(std::string_view(text).substr(0, text.size() - per_cent));
  const double share = number ? *number / (per_cent ? 100 : 1) : -1;
  if (share >= 0 && share <= 1) return share;
  throw Error(fmt::format("{} must be a share from 0 to 1 or from 0% to 100%, got {}; try 99%",
                          flag, text));
}

}  // namespace lumaknot::cli
