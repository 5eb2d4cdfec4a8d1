/// The numbers after a PLY header, as text or binary.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "exporters/ply/header.h"
#include "exporters/text/scanner.h"

namespace lumaknot::ply {

/// One element per line.
class PlyText {
 public:
  static constexpr std::string_view kUnit = "line";
  static std::size_t min_size(PlyType) { return 2; }  // a digit and a blank

  PlyText(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : text_(bytes.substr(header.size), name, header.lines + 1) {}

  std::uint64_t place() const { return text_.line(); }
  std::uint64_t remaining() const { return text_.remaining() + 1; }
  [[noreturn]] void fail(std::string_view what) const { text_.fail(what); }

  void begin_element() {
    if (!text_.next_line()) text_.fail(fmt::format("cut short; {}", kExportAgain));
  }
  double value(PlyType) {
    const std::string_view word = text_.word();
    const auto number = number_of(word);
    if (number) return *number;
    text_.fail(word.empty() ? fmt::format("a number is missing here; {}", kExportAgain)
                            : fmt::format("{} is not a number; {}", in_quotes(word), kExportAgain));
  }
  void end_element() {
    const std::string_view word = text_.word();
    if (word.empty()) return;
    text_.fail(
        fmt::format("{} after the element's last number; {}", in_quotes(word), kExportAgain));
  }
  void finish() {
    if (text_.next_line()) {
      text_.fail(fmt::format("more lines than the header counts; {}", kExportAgain));
    }
  }

 private:
  TextScanner text_;
};

/// One element after another, without gaps.
class PlyBinary {
 public:
  static constexpr std::string_view kUnit = "byte";
  static std::size_t min_size(PlyType type) { return ply_size(type); }

  PlyBinary(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : bytes_(bytes),
        name_(name),
        at_(header.size),
        swaps_((header.encoding == PlyEncoding::kBigEndian) !=
               (std::endian::native == std::endian::big)) {}

  std::uint64_t place() const { return at_; }
  std::uint64_t remaining() const { return bytes_.size() - at_; }
  [[noreturn]] void fail(std::string_view what) const {
    throw file_error(name_, "byte", at_, what);
  }

  void begin_element() {}
  double value(PlyType type) {
    switch (type) {
      case PlyType::kInt8:
        return get<std::int8_t>();
      case PlyType::kUint8:
        return get<std::uint8_t>();
      case PlyType::kInt16:
        return get<std::int16_t>();
      case PlyType::kUint16:
        return get<std::uint16_t>();
      case PlyType::kInt32:
        return get<std::int32_t>();
      case PlyType::kUint32:
        return get<std::uint32_t>();
      case PlyType::kFloat32:
        return double(get<float>());
      default:
        return get<double>();
    }
  }
  void end_element() {}
  void finish() {
    // Some writers end the file with a line break.
    if (bytes_.find_first_not_of(" \r\n", at_) == bytes_.npos) return;
    fail(fmt::format("more bytes than the header counts; {}", kExportAgain));
  }

 private:
  template <class T>
  T get() {
    if (remaining() < sizeof(T)) fail(fmt::format("cut short; {}", kExportAgain));
    char bytes[sizeof(T)];
    std::memcpy(bytes, bytes_.data() + at_, sizeof(T));
    if (swaps_) std::reverse(bytes, bytes + sizeof(T));
    at_ += sizeof(T);
    return std::bit_cast<T>(bytes);
  }

  std::string_view bytes_, name_;
  std::size_t at_;
  bool swaps_;
};

}  // namespace lumaknot::ply
