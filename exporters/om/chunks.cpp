// The format: OpenMesh 9, Core/IO/OMFormat.hh, reader/OMReader.cc and writer/OMWriter.cc.
#include "exporters/om/chunks.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "exporters/text/scanner.h"

namespace lumaknot::om {
namespace {

enum Entity : unsigned { kVertex, kMeshItself, kFace, kEdge = 4, kHalfedge = 6, kEndOfFile = 7 };
enum Type : unsigned { kPosition, kNormal, kUv, kStatus, kColor, kCustom = 6, kTopology = 7 };

constexpr std::size_t kOmHeaderSize = 16;
constexpr std::uint8_t kOldest = 2 << 5, kNewest = kOldest | 2;  // major << 5 | minor

/// The chunks that are kept, in an order in which OpenMesh can read them.
struct OmKind {
  unsigned entity, type, dimensions;
  std::string_view name;
};
enum KindIndex : std::size_t { kPositions, kNormals, kUvs, kHalfedges, kHalfedgeUvs, kFaces };
constexpr std::array kOmKinds{
    OmKind{kVertex, kPosition, 3, "positions"},
    OmKind{kVertex, kNormal, 3, "normals"},
    OmKind{kVertex, kUv, 2, "texture coordinates"},
    OmKind{kHalfedge, kTopology, 3, "halfedges"},
    OmKind{kHalfedge, kUv, 2, "texture coordinates of halfedges"},
    OmKind{kFace, kTopology, 1, "faces"},
};

/// 16 bits: reserved, named, entity, type, signed, float, dimensions - 1, log2 of a number's size.
struct ChunkHeader {
  unsigned entity, type, dimensions, log_size;
  bool is_named, is_float;
};

struct OmChunk {
  std::string_view bytes;  ///< header and data
  std::string_view data;
  std::size_t begin = 0;   ///< of the data in the file
  std::size_t scalar = 0;  ///< bytes of an integer
};

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    value |= std::uint64_t(std::uint8_t(bytes[i])) << (8 * i);
  }
  return value;
}

/// The i-th integer of a chunk, which may be -1.
std::int64_t integer(const OmChunk& chunk, std::size_t i) {
  const unsigned unused = 64 - 8 * unsigned(chunk.scalar);
  const std::uint64_t value = little_endian(chunk.data.substr(i * chunk.scalar, chunk.scalar));
  return std::int64_t(value << unused) >> unused;
}

ChunkHeader chunk_header(std::uint64_t bits) {
  return {.entity = unsigned(bits >> 2 & 7),
          .type = unsigned(bits >> 5 & 15),
          .dimensions = unsigned(bits >> 11 & 7) + 1,
          .log_size = unsigned(bits >> 14 & 3),
          .is_named = (bits >> 1 & 1) != 0,
          .is_float = (bits >> 10 & 1) != 0};
}

/// Bytes per vertex, face, ... of a chunk. Topology's integers are declared as floats.
std::uint64_t element_size(const ChunkHeader& header) {
  if (header.type == kStatus) return 4;
  const bool is_float = header.is_float && header.type != kTopology;
  return std::uint64_t(header.dimensions) * (is_float ? 4u : 1u) << header.log_size;
}

class OmChecker {
 public:
  OmChecker(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  OmFile take() {
    check_header();
    while (at_ < bytes_.size() && pass_chunk()) continue;
    for (const KindIndex kind : {kPositions, kHalfedges, kFaces}) chunk_of(kind);
    check_halfedges();
    check_faces();
    OmFile file{std::string(bytes_.substr(0, kOmHeaderSize)), chunks_[kNormals].has_value(),
                chunks_[kUvs].has_value(), chunks_[kHalfedgeUvs].has_value()};
    for (const auto& chunk : chunks_) {
      if (chunk) file.bytes += chunk->bytes;
    }
    return file;
  }

 private:
  [[noreturn]] void fail(std::size_t at, std::string_view what) const {
    throw file_error(name_, "byte", at, what);
  }

  void check_header() {
    if (bytes_.size() < kOmHeaderSize || !bytes_.starts_with("OM")) {
      fail(0, "not an OM file; is the file's extension right?");
    }
    version_ = std::uint8_t(bytes_[3]);
    if (version_ < kOldest || version_ > kNewest) {
      fail(3, fmt::format("version {}.{}, not 2.0 to 2.2; write it with OpenMesh 9", version_ >> 5,
                          version_ & 31));
    }
    vertices_ = little_endian(bytes_.substr(4, 4));
    faces_ = little_endian(bytes_.substr(8, 4));
    edges_ = little_endian(bytes_.substr(12, 4));
    at_ = kOmHeaderSize;
  }

  /// The next `size` bytes.
  std::string_view take_bytes(std::uint64_t size) {
    if (size > bytes_.size() - at_) {
      fail(at_, fmt::format("{} bytes expected, the file has {}; {}", size, bytes_.size() - at_,
                            kExportAgain));
    }
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

  std::uint64_t count_of(unsigned entity) const {
    switch (entity) {
      case kVertex:
        return vertices_;
      case kMeshItself:
        return 1;
      case kFace:
        return faces_;
      case kEdge:
        return edges_;
      case kHalfedge:
        return 2 * edges_;
      default:
        fail(at_ - 2, fmt::format("a chunk of an unknown kind; {}", kExportAgain));
    }
  }

  /// Reads one chunk and stores it if needed. False at the chunk that ends the file.
  bool pass_chunk() {
    const std::size_t begin = at_;
    const ChunkHeader header = chunk_header(little_endian(take_bytes(2)));
    if (header.entity == kEndOfFile) return false;
    const std::uint64_t count = count_of(header.entity);
    if (header.is_named) take_bytes(little_endian(take_bytes(1)));
    if (header.type == kCustom) {
      if (version_ == kNewest) take_bytes(little_endian(take_bytes(1)));
      take_bytes(little_endian(take_bytes(4)));
      return true;
    }
    const std::size_t data = at_;
    take_bytes(count * element_size(header));
    if (!header.is_named) keep(header, begin, data);
    return true;
  }

  void keep(const ChunkHeader& header, std::size_t begin, std::size_t data) {
    for (std::size_t i = 0; i < kOmKinds.size(); ++i) {
      const OmKind& kind = kOmKinds[i];
      if (header.entity != kind.entity || header.type != kind.type) continue;
      const unsigned max = kind.type == kTopology ? 2 : kind.type == kUv ? 0 : 1;
      if (header.dimensions != kind.dimensions || !header.is_float || header.log_size > max) {
        fail(begin, fmt::format("{} in an unknown form; {}", kind.name, kExportAgain));
      }
      if (chunks_[i]) fail(begin, fmt::format("{} a second time; {}", kind.name, kExportAgain));
      chunks_[i] = OmChunk{bytes_.substr(begin, at_ - begin), bytes_.substr(data, at_ - data), data,
                           std::size_t(1) << header.log_size};
    }
  }

  /// The chunk of a kind that the file must have.
  const OmChunk& chunk_of(KindIndex kind) const {
    if (const auto& chunk = chunks_[kind]) return *chunk;
    fail(at_, fmt::format("the {} are missing; {}", kOmKinds[kind].name, kExportAgain));
  }

  /// The i-th integer of a chunk, which must be `min` to `count` - 1.
  std::int64_t checked(KindIndex kind, std::size_t i, std::int64_t min, std::uint64_t count,
                       std::string_view what) const {
    const OmChunk& chunk = chunk_of(kind);
    const std::int64_t value = integer(chunk, i);
    if (value >= min && value < std::int64_t(count)) return value;
    fail(chunk.begin + i * chunk.scalar, fmt::format("{} {} does not exist, the file has {}; {}",
                                                     what, value, count, kExportAgain));
  }

  /// Each halfedge is three integers: the next halfedge, the vertex it points to, its face or -1.
  void check_halfedges() const {
    for (std::uint64_t h = 0; h < 2 * edges_; ++h) {
      checked(kHalfedges, 3 * h, 0, 2 * edges_, "halfedge");
      const auto to = checked(kHalfedges, 3 * h + 1, 0, vertices_, "vertex");
      checked(kHalfedges, 3 * h + 2, -1, faces_, "face");
      if (h % 2 == 1 && to == integer(chunk_of(kHalfedges), 3 * h - 2)) {
        const OmChunk& chunk = chunk_of(kHalfedges);
        fail(chunk.begin + 3 * h * chunk.scalar,
             fmt::format("an edge from vertex {0} to vertex {0}; {1}", to, kExportAgain));
      }
    }
  }

  /// Following its halfedges, a face returns to the first, and all are its own.
  void check_faces() const {
    const OmChunk& halfedges = chunk_of(kHalfedges);
    std::vector<bool> is_used(2 * edges_);
    for (std::uint64_t f = 0; f < faces_; ++f) {
      const auto first = std::uint64_t(checked(kFaces, f, 0, 2 * edges_, "halfedge"));
      std::uint64_t h = first, size = 0;
      do {
        if (is_used[h] || integer(halfedges, 3 * h + 2) != std::int64_t(f)) {
          fail(halfedges.begin + 3 * h * halfedges.scalar,
               fmt::format("halfedge {} is not in a ring around face {}; {}", h, f, kExportAgain));
        }
        is_used[h] = true;
        ++size;
        h = std::uint64_t(integer(halfedges, 3 * h));
      } while (h != first);
      if (size < 3) {
        fail(chunk_of(kFaces).begin + f * chunk_of(kFaces).scalar,
             fmt::format("a face of {} corners, fewer than 3; {}", size, kExportAgain));
      }
    }
  }

  std::string_view bytes_, name_;
  std::size_t at_ = 0;
  std::uint8_t version_ = 0;
  std::uint64_t vertices_ = 0, faces_ = 0, edges_ = 0;
  std::array<std::optional<OmChunk>, kOmKinds.size()> chunks_;
};

}  // namespace

OmFile checked_om(std::string_view bytes, std::string_view name) {
  return OmChecker(bytes, name).take();
}

}  // namespace lumaknot::om
