#include "exporters/package.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "system/atomic_file.h"
#include "system/error.h"

namespace lumaknot {
namespace {

bool is_utf8(const std::string& text) try {
  nlohmann::json(text).dump();  // refuses anything else
  return true;
} catch (const nlohmann::json::type_error&) {
  return false;
}

}  // namespace

void check_package_name(const std::filesystem::path& path, std::string_view flag) {
  const auto breaks_text = [](char c) {
    return c == '\'' || c == '"' || c == '\\' || (c >= 0 && c < ' ') || c == '\x7f';
  };
  const std::string name = path.filename().string();
  if (!std::ranges::any_of(name, breaks_text) && is_utf8(name)) return;
  throw Error(fmt::format(
      "{} {} must be UTF-8 without quotes or backslashes: other tools' scripts quote the name",
      flag, path.string()));
}

void write_package(const std::filesystem::path& folder, const Package& package,
                   std::string_view flag) {
  for (const PackedFile& file : package) write_file(folder / file.name, file.bytes, flag);
}

}  // namespace lumaknot
