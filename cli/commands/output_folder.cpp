#include "cli/commands/output_folder.h"

#include <fmt/format.h>

#include "system/atomic_file.h"
#include "system/error.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;

/// The folders of the path that don't exist, the innermost first.
std::vector<fs::path> missing(fs::path folder) {
  std::vector<fs::path> all;
  std::error_code ignored;
  while (!folder.empty() && !fs::exists(folder, ignored)) {
    all.push_back(folder);
    folder = folder.parent_path();
  }
  return all;
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder, const std::string& file)
    : created_(missing(folder)) {
  std::error_code error;
  fs::create_directories(folder, error);
  try {
    if (error || !fs::is_directory(folder)) {
      throw Error(fmt::format("--output {} can't be used as a folder: {}; choose another place",
                              folder.string(), error.message()));
    }
    check_writable(folder / file, "--output");
  } catch (const Error&) {
    remove_empty();
    throw;
  }
}

OutputFolder::~OutputFolder() { remove_empty(); }

void OutputFolder::remove_empty() const {
  std::error_code not_empty;
  for (const fs::path& folder : created_) fs::remove(folder, not_empty);
}

}  // namespace lumaknot::cli
