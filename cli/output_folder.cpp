#include "cli/output_folder.h"

#include <fmt/format.h>

#include "scene/atomic_file.h"
#include "scene/error.h"

namespace lumaknot {

void make_output_folder(const std::filesystem::path& folder, const std::string& file) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw Error(fmt::format("--output {} can't be made a folder: {}; choose another place",
                            folder.string(), error.message()));
  }
  const AtomicFile writable(folder / file, "--output");
}

}  // namespace lumaknot
