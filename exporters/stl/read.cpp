// STL: "StereoLithography Interface Specification", 3D Systems, 1988.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>

#include "exporters/mesh/hash_table.h"
#include "exporters/stl/format.h"
#include "exporters/text/scanner.h"

namespace lumaknot::stl {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read without conversion");

constexpr std::size_t kHeaderSize = 84, kFacetSize = 50;

/// Collects facets and gives corners at equal positions one index.
class Facets {
 public:
  void begin(const Vec3d& normal, std::uint64_t place) {
    polygons_.normals.push_back(normal);
    polygons_.places.push_back(place);
    polygons_.sizes.push_back(0);
  }
  void corner(const Vec3d& p) {
    const auto is = [&](std::uint32_t i) { return polygons_.positions[i] == p; };
    const auto next = std::uint32_t(polygons_.positions.size());
    const std::uint32_t index = table_.find_or_add(hash_of({p.x, p.y, p.z}), next, is);
    if (index == next) polygons_.positions.push_back(p);
    polygons_.corners.push_back({index, std::uint32_t(polygons_.normals.size() - 1), kNoIndex});
    ++polygons_.sizes.back();
  }
  Polygons take(std::string_view unit) {
    polygons_.unit = unit;
    return std::move(polygons_);
  }

 private:
  Polygons polygons_;
  IndexTable table_{0};
};

class StlText {
 public:
  StlText(std::string_view bytes, std::string_view name) : text_(bytes, name) {}

  Polygons take() {
    bool is_open = false;
    while (text_.next_line()) {
      const std::string word = lower(text_.word());
      if (word != "solid" && word != "endsolid") {
        if (word != "facet" || !is_open) wrong(word, is_open ? "facet or endsolid" : "solid");
        facet();
      } else {
        if ((word == "endsolid") != is_open) wrong(word, is_open ? "endsolid" : "solid");
        is_open = !is_open;
      }
    }
    if (is_open) text_.fail(fmt::format("cut short before endsolid; {}", kExportAgain));
    return facets_.take("line");
  }

 private:
  static std::string lower(std::string_view word) {
    std::string text(word);
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return text;
  }

  [[noreturn]] void wrong(std::string_view word, std::string_view wanted) const {
    text_.fail(fmt::format("{} where {} was expected; {}",
                           word.empty() ? "nothing" : in_quotes(word), wanted, kExportAgain));
  }

  void expect(std::string_view wanted) {
    const std::string word = lower(text_.word());
    if (word != wanted) wrong(word, wanted);
  }

  void expect_line(std::string_view wanted) {
    if (!text_.next_line())
      text_.fail(fmt::format("cut short before {}; {}", wanted, kExportAgain));
    expect(wanted);
  }

  Vec3d vector() {
    const double x = text_.number(), y = text_.number();
    return {x, y, text_.number()};
  }

  void facet() {
    const std::uint64_t line = text_.line();
    expect("normal");
    facets_.begin(vector(), line);
    expect_line("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) {
      expect_line("vertex");
      facets_.corner(vector());
    }
    expect_line("endloop");
    expect_line("endfacet");
  }

  TextScanner text_;
  Facets facets_;
};

float float_at(std::string_view bytes, std::size_t at) {
  float value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

Vec3d vector_at(std::string_view bytes, std::size_t at, std::string_view name) {
  const Vec3d v{float_at(bytes, at), float_at(bytes, at + 4), float_at(bytes, at + 8)};
  if (is_finite(v)) return v;
  throw file_error(name, "byte", at, fmt::format("a number that is not finite; {}", kExportAgain));
}

std::uint64_t facets_said(std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= kHeaderSize) std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

Polygons read_binary(std::string_view bytes, std::string_view name) {
  const std::uint64_t count = facets_said(bytes);
  if (count > (kNoIndex - 1) / 3) {
    throw file_error(name, "byte", 80,
                     fmt::format("{} facets have more than 2^32 - 2 corners", count));
  }
  Facets facets;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::size_t at = kHeaderSize + i * kFacetSize;
    facets.begin(vector_at(bytes, at, name), at);
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      facets.corner(vector_at(bytes, at + 12 * corner, name));
    }
  }
  return facets.take("byte");
}

}  // namespace

Polygons read(std::string_view bytes, std::string_view name) {
  const std::uint64_t count = facets_said(bytes);
  // Binary files may begin with "solid" too, but no text has this size by chance.
  if (bytes.size() == kHeaderSize + count * kFacetSize) return read_binary(bytes, name);
  const std::size_t word = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  if (bytes.substr(word).starts_with("solid") || bytes.substr(word).starts_with("SOLID")) {
    return StlText(bytes, name).take();
  }
  throw file_error(
      name, "byte", std::min<std::size_t>(80, bytes.size()),
      fmt::format("neither the word solid at the file's beginning nor, for binary STL, a "
                  "count that {} bytes hold; {}",
                  bytes.size(), kExportAgain));
}

}  // namespace lumaknot::stl
