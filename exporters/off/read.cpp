// OFF: Geomview's manual, section 4.2.5. The header is [ST][C][N]OFF; a vertex is its position,
// normal, colour and texture coordinate.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "exporters/off/format.h"
#include "exporters/text/scanner.h"

namespace lumaknot::off {
namespace {

class OffReader {
 public:
  OffReader(std::string_view bytes, std::string_view name) : text_(bytes, name) {}

  Polygons take() {
    if (!text_.next_line()) text_.fail("not an OFF file: it is empty");
    header(text_.word());
    counts();
    for (std::uint64_t i = 0; i < vertices_; ++i) {
      line_of("vertices", vertices_, i);
      vertex();
    }
    for (std::uint64_t i = 0; i < faces_; ++i) {
      line_of("faces", faces_, i);
      face();
    }
    if (text_.next_line())
      text_.fail(fmt::format("more lines than the header counts; {}", kExportAgain));
    return std::move(polygons_);
  }

 private:
  void header(std::string_view word) {
    std::string_view rest = word;
    const auto has = [&](std::string_view prefix) {
      const bool found = rest.starts_with(prefix);
      if (found) rest.remove_prefix(prefix.size());
      return found;
    };
    has_uvs_ = has("ST");
    has("C");
    has_normals_ = has("N");
    if (rest == "OFF") return;
    text_.fail(rest.ends_with("OFF")
                   ? fmt::format("{} has coordinates that are not 3; write OFF", in_quotes(word))
                   : fmt::format("{} where OFF was expected: not an OFF file", in_quotes(word)));
  }

  /// Vertices, faces and perhaps edges, after the header or on the next line.
  void counts() {
    const TextScanner before = text_;
    const std::string_view word = text_.word();
    if (word == "BINARY") text_.fail("binary OFF is not read; write it as text");
    if (!word.empty()) {
      text_ = before;
    } else if (!text_.next_line()) {
      text_.fail(fmt::format("cut short before the counts; {}", kExportAgain));
    }
    vertices_ = text_.count();
    faces_ = text_.count();
    // The shortest vertex is "0 0 0\n", the shortest face "3 0 1 2\n"; the last needs no \n.
    const std::uint64_t bytes = text_.remaining() + 1;
    if (vertices_ <= bytes / 6 && faces_ <= bytes / 8) return;
    text_.fail(fmt::format("{} vertices and {} faces are more than the file can hold; {}",
                           vertices_, faces_, kExportAgain));
  }

  void line_of(std::string_view what, std::uint64_t count, std::uint64_t i) {
    if (text_.next_line()) return;
    text_.fail(fmt::format("cut short after {} of {} {}; {}", i, count, what, kExportAgain));
  }

  void vertex() {
    polygons_.positions.push_back(vector());
    if (has_normals_) polygons_.normals.push_back(vector());
    if (!has_uvs_) return;
    // Colours with any number of components may come in between.
    std::vector<double> rest;
    for (auto word = text_.word(); !word.empty(); word = text_.word()) {
      rest.push_back(number_of(word).value_or(NAN));
    }
    if (rest.size() < 2 || !is_usable(rest.end()[-2]) || !is_usable(rest.back())) {
      text_.fail(fmt::format("no texture coordinate at the end of the line; {}", kExportAgain));
    }
    polygons_.uvs.push_back({rest.end()[-2], rest.back()});
  }

  Vec3d vector() {
    const double x = text_.number(), y = text_.number();
    return {x, y, text_.number()};
  }

  void face() {
    const std::uint64_t size = text_.count();
    if (size < 3)
      text_.fail(fmt::format("a face of {} corners, fewer than 3; {}", size, kExportAgain));
    for (std::uint64_t i = 0; i < size; ++i) {
      const std::uint64_t vertex = text_.count();
      if (vertex >= vertices_ || vertex >= kNoIndex) {
        text_.fail(fmt::format("vertex {} does not exist, the file has {}, from 0 on; {}", vertex,
                               vertices_, kExportAgain));
      }
      const auto index = std::uint32_t(vertex);
      polygons_.corners.push_back(
          {index, has_normals_ ? index : kNoIndex, has_uvs_ ? index : kNoIndex});
    }
    polygons_.sizes.push_back(std::uint32_t(size));
    polygons_.places.push_back(text_.line());
  }

  TextScanner text_;
  Polygons polygons_;
  bool has_uvs_ = false, has_normals_ = false;
  std::uint64_t vertices_ = 0, faces_ = 0;
};

}  // namespace

Polygons read(std::string_view bytes, std::string_view name) {
  return OffReader(bytes, name).take();
}

}  // namespace lumaknot::off
