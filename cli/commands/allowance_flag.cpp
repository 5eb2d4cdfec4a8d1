#include "cli/commands/allowance_flag.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "cli/commands/shares.h"
#include "system/error.h"

namespace lumaknot::cli {
Argument allow_argument(std::vector<std::string>& values) {
  Argument argument{
      .names = "--allow",
      .target = &values,
      .meaning = "share of a known difference to accept, of the covered pixels or the silhouette",
      .value = "CLASS=SHARE,...",
      .checked = false,
      .list = true};
  for (const std::string_view name : validate::kAllowanceNames) {
    argument.choices.emplace_back(name);
  }
  return argument;
}

validate::Allowances allowances_of(const std::vector<std::string>& values) {
  validate::Allowances result;
  for (const std::string& value : values) {
    const std::size_t equals = value.find('=');
    const auto name =
        std::ranges::find(validate::kAllowanceNames, std::string_view(value).substr(0, equals));
    if (name == validate::kAllowanceNames.end()) {
      throw Error(fmt::format("--allow {} is not a known difference; known: {}", value,
                              fmt::join(validate::kAllowanceNames, ", ")));
    }
    const std::string share = equals == std::string::npos ? "" : value.substr(equals + 1);
    result.stated[std::size_t(name - validate::kAllowanceNames.begin())] =
        share_of(fmt::format("--allow {}", *name), share);
  }
  return result;
}

}  // namespace lumaknot::cli
