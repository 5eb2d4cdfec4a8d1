/// The folder that a command writes several files into.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lumaknot {

/// A folder that is there while it lives; what of it was made here goes with it when nothing was
/// written.
class OutputFolder {
 public:
  /// Throws Error naming --output unless `file` could be written into it.
  OutputFolder(const std::filesystem::path& folder, const std::string& file);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  void remove_what_is_empty() const;

  std::vector<std::filesystem::path> made_;  ///< the innermost first
};

}  // namespace lumaknot
