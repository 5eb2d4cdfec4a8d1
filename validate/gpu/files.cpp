#include "validate/gpu/files.h"

namespace lumaknot::gpu {

namespace fs = std::filesystem;

std::uint64_t checked_size(const fs::path& path, const std::string& where, std::uint64_t min,
                           std::uint64_t max) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(path, error);
  if (error) {
    throw Error(fmt::format("{} can't be read: {} ({})", where, path.string(), error.message()));
  }
  if (size >= min && size <= max) return size;
  const std::string wanted = min == max ? std::to_string(min) : fmt::format("{} to {}", min, max);
  throw Error(fmt::format("{} must have {} bytes, {} has {}", where, wanted, path.string(), size));
}

void read_into(void* to, std::uint64_t size, const fs::path& path, const std::string& where) {
  std::ifstream stream(path, std::ios::binary);
  stream.read(static_cast<char*>(to), std::streamsize(size));
  if (!stream) throw Error(fmt::format("{} can't be read: {}", where, path.string()));
}

std::string read_text(const fs::path& path, const std::string& where, std::uint64_t max) {
  std::string text(checked_size(path, where, 1, max), '\0');
  read_into(text.data(), text.size(), path, where);
  return text;
}

}  // namespace lumaknot::gpu
