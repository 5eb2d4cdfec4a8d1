/// The folder that a command writes several files into.
#pragma once

#include <filesystem>

namespace lumaknot {

/// Makes `folder` where it is not there, and throws Error naming --output unless `file` could be
/// written into it.
void make_output_folder(const std::filesystem::path& folder, const std::string& file);

}  // namespace lumaknot
