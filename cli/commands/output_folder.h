/// The folder to which a command writes several files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lumaknot::cli {

/// Creates a folder; folders created here that are still empty are removed on destruction.
class OutputFolder {
 public:
  /// Throws Error naming --output unless `file` can be written into it.
  OutputFolder(const std::filesystem::path& folder, const std::string& file);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  void remove_empty() const;

  std::vector<std::filesystem::path> created_;  ///< the innermost first
};

}  // namespace lumaknot::cli
