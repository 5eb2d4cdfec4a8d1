/// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

namespace lumaknot {

/// A file written next to `path`: write to `temporary()`, then `commit()` renames it to `path`.
/// Destroyed without a commit it removes the temporary file and leaves any file at `path`
/// unchanged. The temporary keeps the extension; a symbolic link is followed, and a file's
/// permissions are kept. Throws Error when the folder is not writable or `path` is anything but a
/// regular file.
class AtomicFile {
 public:
  /// `flag` is what an error calls the path's origin, for example "--output".
  AtomicFile(std::filesystem::path path, std::string_view flag);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }
  void commit();

 private:
  std::filesystem::path path_, temporary_;
  std::string flag_;
};

/// Writes `bytes` to `path`, whole or not at all.
void write_file(const std::filesystem::path& path, std::string_view bytes, std::string_view flag);

/// Throws the Error of writing to `path` before there is anything to write. Changes nothing.
void check_writable(const std::filesystem::path& path, std::string_view flag);

/// Throws Error, naming `flag`, unless `path` ends in one of `endings`, each including its dot.
void check_ending(const std::filesystem::path& path, std::span<const std::string_view> endings,
                  std::string_view flag);

/// Writes to `path` the bytes that `write` sends to its stream, whole or not at all. Exceptions of
/// `write` propagate.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write,
                std::string_view flag);

/// The bytes of the file at `path`. Throws Error calling it `label`.
std::string read_file(const std::filesystem::path& path, std::string_view label);

}  // namespace lumaknot
