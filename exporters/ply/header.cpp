// G. Turk, "The PLY Polygon File Format", 1994.
#include "exporters/ply/header.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "exporters/text/scanner.h"

namespace lumaknot::ply {
namespace {

constexpr std::pair<std::string_view, PlyType> kTypes[] = {
    {"char", PlyType::kInt8},       {"int8", PlyType::kInt8},       {"uchar", PlyType::kUint8},
    {"uint8", PlyType::kUint8},     {"short", PlyType::kInt16},     {"int16", PlyType::kInt16},
    {"ushort", PlyType::kUint16},   {"uint16", PlyType::kUint16},   {"int", PlyType::kInt32},
    {"int32", PlyType::kInt32},     {"uint", PlyType::kUint32},     {"uint32", PlyType::kUint32},
    {"float", PlyType::kFloat32},   {"float32", PlyType::kFloat32}, {"double", PlyType::kFloat64},
    {"float64", PlyType::kFloat64},
};

constexpr std::pair<std::string_view, PlyEncoding> kEncodings[] = {
    {"ascii", PlyEncoding::kText},
    {"binary_little_endian", PlyEncoding::kLittleEndian},
    {"binary_big_endian", PlyEncoding::kBigEndian},
};

class HeaderReader {
 public:
  HeaderReader(std::string_view text, std::string_view name) : text_(text, name) {}

  PlyHeader take() {
    if (!text_.next_line() || text_.word() != "ply") text_.fail("the first word is not ply");
    bool has_format = false;
    while (text_.next_line()) {
      const std::string_view keyword = text_.word();
      if (keyword == "format") {
        header_.encoding = one_of(kEncodings, text_.word(), "format");
        has_format = true;
      } else if (keyword == "element") {
        header_.elements.push_back({std::string(text_.word()), text_.count(), {}});
      } else if (keyword == "property") {
        property();
      } else if (keyword == "end_header") {
        break;
      } else if (keyword != "comment" && keyword != "obj_info") {
        text_.fail(fmt::format("{} is not a keyword of a PLY header; {}", in_quotes(keyword),
                               kExportAgain));
      }
    }
    if (!has_format) text_.fail(fmt::format("the header names no format; {}", kExportAgain));
    return std::move(header_);
  }

 private:
  template <class Value, std::size_t kSize>
  Value one_of(const std::pair<std::string_view, Value> (&table)[kSize], std::string_view word,
               std::string_view what) const {
    const auto found = std::ranges::find(table, word, [](const auto& row) { return row.first; });
    if (found != std::end(table)) return found->second;
    text_.fail(fmt::format("{} {} is not known; {}", what, in_quotes(word), kExportAgain));
  }

  void property() {
    if (header_.elements.empty()) {
      text_.fail(fmt::format("a property before any element; {}", kExportAgain));
    }
    PlyProperty property;
    std::string_view type = text_.word();
    if (type == "list") {
      property.count = one_of(kTypes, text_.word(), "type");
      type = text_.word();
    }
    property.type = one_of(kTypes, type, "type");
    property.name = text_.word();
    header_.elements.back().properties.push_back(std::move(property));
  }

  TextScanner text_;
  PlyHeader header_;
};

}  // namespace

std::size_t ply_size(PlyType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[std::size_t(type)];
}

PlyHeader ply_header(std::string_view bytes, std::string_view name) {
  if (!bytes.starts_with("ply")) {
    throw file_error(name, "line", 1, "not a PLY file; is the file's extension right?");
  }
  const std::size_t end = bytes.find("\nend_header");
  const std::size_t size = end == bytes.npos ? end : bytes.find('\n', end + 1);
  if (size == bytes.npos) {
    throw file_error(
        name, "line", 1,
        fmt::format("no line end_header: cut short, or not a PLY file; {}", kExportAgain));
  }
  const std::string_view text = bytes.substr(0, size + 1);
  PlyHeader header = HeaderReader(text, name).take();
  header.size = text.size();
  header.lines = std::uint64_t(std::ranges::count(text, '\n'));
  return header;
}

}  // namespace lumaknot::ply
