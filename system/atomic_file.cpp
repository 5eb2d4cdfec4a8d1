#include "system/atomic_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "system/error.h"

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(std::string_view flag, const fs::path& path, std::string_view why) {
  throw Error(
      fmt::format("{} {} can't be written: {}; choose another place", flag, path.string(), why));
}

}  // namespace

AtomicFile::AtomicFile(fs::path path, std::string_view flag) : path_(std::move(path)), flag_(flag) {
  std::error_code ignored;
  if (fs::is_directory(path_, ignored)) fail(flag_, path_, "it is a folder");
  if (fs::exists(path_, ignored)) {
    if (!fs::is_regular_file(path_, ignored)) fail(flag_, path_, "it is not a regular file");
    path_ = fs::canonical(path_);
  }
  temporary_ = path_;
  temporary_.replace_filename(
      fmt::format(".lumaknot-{}-{}{}", ::getpid(), fmt::ptr(this), path_.extension().string()));
  if (!std::ofstream(temporary_, std::ios::binary)) fail(flag_, path_, std::strerror(errno));
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  std::error_code error, ignored;
  const fs::file_status old = fs::status(path_, ignored);
  if (fs::exists(old)) fs::permissions(temporary_, old.permissions(), ignored);
  fs::rename(temporary_, path_, error);
  if (error) fail(flag_, path_, error.message());
  temporary_.clear();
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& write,
                std::string_view flag) {
  AtomicFile file(path, flag);
  std::ofstream stream(file.temporary(), std::ios::binary);
  write(stream);
  stream.close();
  // Another thread may have written, so errno does not give the reason.
  if (!stream) fail(flag, path, "its disk took only part of it");
  file.commit();
}

void check_writable(const fs::path& path, std::string_view flag) { AtomicFile(path, flag); }

void check_ending(const fs::path& path, std::span<const std::string_view> endings,
                  std::string_view flag) {
  if (std::ranges::count(endings, path.extension().string()) > 0) return;
  throw Error(fmt::format("{} {} must end in {}", flag, path.string(), fmt::join(endings, " or ")));
}

void write_file(const fs::path& path, std::string_view bytes, std::string_view flag) {
  const auto write = [&](std::ostream& stream) {
    stream.write(bytes.data(), std::streamsize(bytes.size()));
  };
  write_file(path, write, flag);
}

std::string read_file(const fs::path& path, std::string_view label) {
  std::error_code ignored;
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (fs::is_directory(path, ignored) || !stream) {
    throw Error(fmt::format("{} can't be read: {} ({})", label, path.string(),
                            errno ? std::strerror(errno) : "it is a folder"));
  }
  // Devices and pipes report no size, so read until the end.
  const std::uintmax_t reported = fs::file_size(path, ignored);
  std::string bytes(ignored ? 0 : std::size_t(reported), '\0');
  std::size_t size = 0;
  while (stream) {
    constexpr std::size_t kStep = 1 << 16;
    if (size == bytes.size()) bytes.resize(size + std::max(kStep, size));
    stream.read(bytes.data() + size, std::streamsize(bytes.size() - size));
    size += std::size_t(stream.gcount());
    if (size == reported && stream.peek() == std::ifstream::traits_type::eof()) break;
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace lumaknot
