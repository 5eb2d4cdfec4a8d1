/// The files that a job names, checked before memory is allocated for them.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "system/error.h"

namespace lumaknot::gpu {

/// The size in bytes of the regular file at `path`, which must be in [min, max]. `where` is the
/// field that named it. Throws Error.
std::uint64_t checked_size(const std::filesystem::path& path, const std::string& where,
                           std::uint64_t min, std::uint64_t max);

/// Fills `size` bytes at `to` from the file's start.
void read_into(void* to, std::uint64_t size, const std::filesystem::path& path,
               const std::string& where);

/// A file of exactly `count` values of type T, in their memory layout.
template <class T>
std::vector<T> read_array(const std::filesystem::path& path, const std::string& where,
                          std::uint64_t count) {
  const std::uint64_t size = count * sizeof(T);
  checked_size(path, where, size, size);
  std::vector<T> values(count);
  read_into(values.data(), size, path, where);
  return values;
}

/// A file of 1 to `max` bytes.
std::string read_text(const std::filesystem::path& path, const std::string& where,
                      std::uint64_t max);

}  // namespace lumaknot::gpu
