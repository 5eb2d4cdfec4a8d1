#include "exporters/gltf/container.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

#include "exporters/gltf/json.h"

namespace lumaknot::gltf {
namespace {

/// The 4 bytes at `at` as an unsigned integer.
std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

/// A chunk's type and contents.
struct Chunk {
  std::uint32_t type = 0;
  std::string_view content;
};

/// The chunk whose header begins at byte `at`.
Chunk chunk_at(std::string_view bytes, std::size_t at, std::string_view name) {
  constexpr std::size_t kHeader = 8;
  const auto place = fmt::format("byte {}", at);
  if (bytes.size() - at < kHeader) {
    fail_gltf(name, place, "begins a chunk whose header is cut short; export it again");
  }
  const std::uint64_t length = word(bytes, at), left = bytes.size() - at - kHeader;
  if (length > left) {
    fail_gltf(name, place,
              fmt::format("begins a chunk of {} bytes, of which {} exist; the "
                          "file is cut short",
                          length, left));
  }
  return {word(bytes, at + 4), bytes.substr(at + kHeader, length)};
}

}  // namespace

GltfChunks gltf_chunks(std::string_view bytes, std::string_view name) {
  constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
  constexpr std::size_t kHeader = 12;
  if (!bytes.starts_with("glTF")) return {bytes, {}};
  if (bytes.size() < kHeader) {
    fail_gltf(name, "byte 4", "ends the file within its header; export it again");
  }
  if (word(bytes, 4) != 2) {
    fail_gltf(name, "byte 4",
              fmt::format("has version {} of glTF, not 2; export it as glTF 2.0", word(bytes, 4)));
  }
  if (word(bytes, 8) != bytes.size()) {
    fail_gltf(name, "byte 8",
              fmt::format("states {} bytes, but the file has {}; copy it again", word(bytes, 8),
                          bytes.size()));
  }
  const Chunk json = chunk_at(bytes, kHeader, name);
  if (json.type != kJson) {
    fail_gltf(name, "byte 16", "must begin with a JSON chunk; export it again");
  }
  const std::size_t end = kHeader + 8 + json.content.size();
  if (end == bytes.size()) return {json.content, {}};
  const Chunk binary = chunk_at(bytes, end, name);
  return {json.content, binary.type == kBinary ? binary.content : std::string_view()};
}

}  // namespace lumaknot::gltf
