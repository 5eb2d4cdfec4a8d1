/// A scene for another tool: a few files that belong together.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lumaknot {

struct PackedFile {
  std::string name;  ///< without a folder
  std::string bytes;
};

/// Files in one folder that refer to each other by name.
using Package = std::vector<PackedFile>;

/// Throws Error, naming `flag`, when the file name of `path` can't be quoted in another tool's
/// script: quotes, backslashes and control characters.
void check_package_name(const std::filesystem::path& path, std::string_view flag);

/// Writes each file whole or not at all, the last one last: it is the one to open.
void write_package(const std::filesystem::path& folder, const Package& package,
                   std::string_view flag);

}  // namespace lumaknot
