#include "cli/output_folder.h"

#include <fmt/format.h>

#include "scene/atomic_file.h"
#include "scene/error.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

/// The folder and those about it that are not there.
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
    : made_(missing(folder)) {
  std::error_code error;
  fs::create_directories(folder, error);
  try {
    if (error || !fs::is_directory(folder)) {
      throw Error(fmt::format("--output {} can't be made a folder: {}; choose another place",
                              folder.string(), error.message()));
    }
    check_writable(folder / file, "--output");
  } catch (const Error&) {
    remove_what_is_empty();
    throw;
  }
}

OutputFolder::~OutputFolder() { remove_what_is_empty(); }

void OutputFolder::remove_what_is_empty() const {
  std::error_code is_full;
  for (const fs::path& folder : made_) fs::remove(folder, is_full);
}

}  // namespace lumaknot
