/// The header of a PLY file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lumaknot::ply {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };
enum class PlyEncoding { kText, kLittleEndian, kBigEndian };

/// Bytes of one number.
std::size_t ply_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;
  std::optional<PlyType> count;  ///< the type of a list's count
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kText;
  std::vector<PlyElement> elements;
  std::size_t size = 0;     ///< bytes up to the data
  std::uint64_t lines = 0;  ///< lines up to the data
};

/// The header at the beginning of `bytes`. Throws Error with the line, calling the file `name`.
PlyHeader ply_header(std::string_view bytes, std::string_view name);

}  // namespace lumaknot::ply
