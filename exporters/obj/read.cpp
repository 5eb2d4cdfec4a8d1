// Wavefront OBJ: "Object Files (.obj)", Advanced Visualizer manual, appendix B1.
#include <fmt/format.h>

#include <array>

#include "exporters/mesh/edges.h"
#include "exporters/obj/format.h"
#include "exporters/text/scanner.h"

namespace lumaknot::obj {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view bytes, std::string_view name) : text_(bytes, name) {
    polygons_.first_index = 1;
  }

  Polygons take() {
    while (text_.next_line()) {
      const std::string_view keyword = text_.word();
      if (keyword == "v") {
        polygons_.positions.push_back(vector());
      } else if (keyword == "vn") {
        polygons_.normals.push_back(vector());
      } else if (keyword == "vt") {
        polygons_.uvs.push_back(uv());
      } else if (keyword == "f" || keyword == "fo") {
        face();
      }
    }
    return std::move(polygons_);
  }

 private:
  Vec3d vector() {
    const double x = text_.number(), y = text_.number();
    return {x, y, text_.number()};
  }

  Vec2d uv() {
    const double u = text_.number();
    const std::string_view second = text_.word();
    if (second.empty()) return {u, 0};
    const auto v = number_of(second);
    if (!v || !is_usable(*v)) {
      text_.fail(fmt::format("{} is not a finite number; {}", in_quotes(second), kExportAgain));
    }
    return {u, *v};
  }

  void face() {
    const std::uint64_t line = text_.line();
    const std::size_t before = polygons_.corners.size();
    for (auto word = text_.word(); !word.empty(); word = text_.word()) {
      polygons_.corners.push_back(corner(word));
    }
    const std::size_t size = polygons_.corners.size() - before;
    if (size < 3) {
      text_.fail(fmt::format("a face of {} corners, fewer than 3; {}", size, kExportAgain));
    }
    polygons_.sizes.push_back(std::uint32_t(size));
    polygons_.places.push_back(line);
  }

  /// position, position/uv, position//normal or position/uv/normal.
  PolygonCorner corner(std::string_view word) const {
    std::array<std::string_view, 3> parts;
    std::string_view rest = word;
    for (std::size_t i = 0;; ++i) {
      const std::size_t slash = rest.find('/');
      parts[i] = rest.substr(0, slash);
      if (slash == rest.npos) break;
      if (i == 2) text_.fail(fmt::format("{} is not a face corner", in_quotes(word)));
      rest.remove_prefix(slash + 1);
    }
    PolygonCorner corner;
    corner.position = index(parts[0], polygons_.positions.size(), "vertex");
    if (!parts[1].empty()) corner.uv = index(parts[1], polygons_.uvs.size(), "texture coordinate");
    if (!parts[2].empty()) corner.normal = index(parts[2], polygons_.normals.size(), "normal");
    return corner;
  }

  /// Counted forwards from 1, or backwards from -1 among the `size` read so far.
  std::uint32_t index(std::string_view word, std::size_t size, std::string_view what) const {
    const auto number = integer_of(word);
    if (!number) {
      text_.fail(
          fmt::format("{} is not a valid {} index; {}", in_quotes(word), what, kExportAgain));
    }
    const bool is_there = *number > 0 ? *number < std::int64_t(kNoIndex)
                                      : *number < 0 && *number >= -std::int64_t(size);
    if (!is_there) {
      text_.fail(fmt::format("{} {} does not exist, {} come before; {}", what, in_quotes(word),
                             size, kExportAgain));
    }
    return std::uint32_t(*number > 0 ? *number - 1 : std::int64_t(size) + *number);
  }

  TextScanner text_;
  Polygons polygons_;
};

}  // namespace

Polygons read(std::string_view bytes, std::string_view name) {
  Polygons polygons = ObjReader(bytes, name).take();
  check_indices(polygons, name);
  return polygons;
}

}  // namespace lumaknot::obj
