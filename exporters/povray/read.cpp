// mesh2: POV-Ray 3.7's manual, section 2.4.2.4.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "exporters/povray/format.h"
#include "exporters/povray/tokens.h"
#include "exporters/text/scanner.h"

namespace lumaknot::povray {
namespace {

class PovReader {
 public:
  PovReader(std::string_view text, std::string_view name) : tokens_(text, name), name_(name) {}

  Polygons take() {
    std::size_t found = 0;
    for (auto token = tokens_.next(); !token.empty(); token = tokens_.next()) {
      if (token != "mesh2" || tokens_.peek() != "{") continue;
      mesh2();
      ++found;
    }
    if (found == 0) tokens_.fail("the file ends without a mesh2 { ... }, the only object read");
    return std::move(polygons_);
  }

 private:
  /// The start of a mesh2's own arrays within the combined ones.
  struct Start {
    std::size_t position, normal, uv, corner, polygon;
  };
  using Indices = std::vector<std::array<std::uint32_t, 3>>;

  void mesh2() {
    const std::uint64_t line = tokens_.line();
    start_ = {polygons_.positions.size(), polygons_.normals.size(), polygons_.uvs.size(),
              polygons_.corners.size(), polygons_.sizes.size()};
    Indices normal_indices, uv_indices;
    expect("{");
    for (auto token = tokens_.next(); token != "}"; token = tokens_.next()) {
      if (token.empty()) tokens_.fail(fmt::format("the mesh2 of line {} does not end", line));
      if (token == "vertex_vectors") {
        list(7, [&] { polygons_.positions.push_back(vector()); });
      } else if (token == "normal_vectors") {
        list(7, [&] { polygons_.normals.push_back(vector()); });
      } else if (token == "uv_vectors") {
        list(5, [&] { polygons_.uvs.push_back(uv()); });
      } else if (token == "face_indices") {
        list(7, [&] { face(); });
      } else if (token == "normal_indices") {
        list(7, [&] { normal_indices.push_back(indices()); });
      } else if (token == "uv_indices") {
        list(7, [&] { uv_indices.push_back(indices()); });
      } else {
        other(token);
      }
    }
    join(normal_indices, uv_indices);
  }

  /// Items that do not define the mesh's shape are skipped.
  void other(std::string_view token) {
    constexpr std::string_view kMoves[] = {"translate", "rotate", "scale", "matrix", "transform"};
    if (std::ranges::find(kMoves, token) != std::end(kMoves)) {
      tokens_.fail(fmt::format("{} moves the mesh, which is not read; move its vertices", token));
    }
    if (token != "{") return;
    const std::uint64_t line = tokens_.line();
    for (std::size_t depth = 1; depth > 0;) {
      const std::string_view next = tokens_.next();
      if (next.empty()) tokens_.fail(fmt::format("the {{ of line {} is not closed", line));
      depth += next == "{";
      depth -= next == "}";
    }
  }

  void expect(std::string_view wanted) {
    const std::string_view token = tokens_.next();
    if (token == wanted) return;
    if (token.empty()) tokens_.fail(fmt::format("cut short before {}; {}", wanted, kExportAgain));
    tokens_.fail(fmt::format("{} where {} was expected: only numbers are read, no expressions",
                             in_quotes(token), wanted));
  }

  void pass_comma() {
    if (tokens_.peek() == ",") tokens_.next();
  }

  /// { count, item, item ... }, an item being at least `min` bytes.
  template <class Item>
  void list(std::size_t min, Item item) {
    expect("{");
    const std::uint64_t count = integer();
    if (count > tokens_.remaining() / min) {
      tokens_.fail(fmt::format("a list of {}, which the file can't hold; {}", count, kExportAgain));
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      pass_comma();
      item();
    }
    pass_comma();
    expect("}");
  }

  double number() {
    const std::string_view token = tokens_.next();
    if (token.empty()) tokens_.fail(fmt::format("cut short before a number; {}", kExportAgain));
    const auto value = number_of(token);
    if (!value || token[0] == 'n' || token[0] == 'i') {
      tokens_.fail(fmt::format("{} is not a number: only numbers are read, no expressions",
                               in_quotes(token)));
    }
    if (!is_usable(*value)) {
      tokens_.fail(fmt::format("{} is not a finite float32 number", in_quotes(token)));
    }
    return *value;
  }

  std::uint64_t integer() {
    const double value = number();
    constexpr double kBeyond = 9e15;  // beyond this doubles are not exact integers
    if (value >= 0 && value < kBeyond && value == double(std::uint64_t(value))) {
      return std::uint64_t(value);
    }
    tokens_.fail(fmt::format("{} is not a count or an index; {}", value, kExportAgain));
  }

  Vec3d vector() {
    expect("<");
    const double x = number();
    expect(",");
    const double y = number();
    expect(",");
    const double z = number();
    expect(">");
    return {x, y, z};
  }

  Vec2d uv() {
    expect("<");
    const double u = number();
    expect(",");
    const double v = number();
    expect(">");
    return {u, v};
  }

  std::array<std::uint32_t, 3> indices() {
    std::array<std::uint32_t, 3> indices{};
    expect("<");
    for (std::size_t i = 0; i < 3; ++i) {
      if (i > 0) expect(",");
      const std::uint64_t index = integer();
      if (index >= kNoIndex)
        tokens_.fail(fmt::format("index {} does not exist; {}", index, kExportAgain));
      indices[i] = std::uint32_t(index);
    }
    expect(">");
    return indices;
  }

  /// A triangle, and the numbers of its textures.
  void face() {
    polygons_.places.push_back(tokens_.line());
    polygons_.sizes.push_back(3);
    for (const std::uint32_t i : indices()) polygons_.corners.push_back({i, kNoIndex, kNoIndex});
    for (auto token = tokens_.peek(); token == "," || number_of(token); token = tokens_.peek()) {
      tokens_.next();
    }
  }

  void join(const Indices& normals, const Indices& uvs) {
    check_size("normal_indices", normals.size());
    check_size("uv_indices", uvs.size());
    const bool has_normals = polygons_.normals.size() > start_.normal;
    const bool has_uvs = polygons_.uvs.size() > start_.uv;
    for (std::size_t i = start_.corner; i < polygons_.corners.size(); ++i) {
      PolygonCorner& corner = polygons_.corners[i];
      const std::size_t face = (i - start_.corner) / 3, at = (i - start_.corner) % 3;
      const std::uint32_t index = corner.position;
      const auto moved = [&](std::string_view what, std::uint32_t own, std::size_t start,
                             std::size_t end) {
        if (own < end - start) return std::uint32_t(start + own);
        throw file_error(name_, "line", polygons_.places[start_.polygon + face],
                         fmt::format("{} {} does not exist, the mesh2 has {}, from 0 on; {}", what,
                                     own, end - start, kExportAgain));
      };
      corner.position = moved("vertex", index, start_.position, polygons_.positions.size());
      if (has_normals) {
        corner.normal = moved("normal", normals.empty() ? index : normals[face][at], start_.normal,
                              polygons_.normals.size());
      }
      if (has_uvs) {
        corner.uv = moved("texture coordinate", uvs.empty() ? index : uvs[face][at], start_.uv,
                          polygons_.uvs.size());
      }
    }
  }

  void check_size(std::string_view what, std::size_t size) const {
    const std::size_t faces = polygons_.sizes.size() - start_.polygon;
    if (size == 0 || size == faces) return;
    tokens_.fail(fmt::format("{} {} for {} faces; {}", size, what, faces, kExportAgain));
  }

  PovTokens tokens_;
  std::string_view name_;
  Polygons polygons_;
  Start start_{};
};

}  // namespace

Polygons read_pov(std::string_view bytes, std::string_view name) {
  const TextScanner text(bytes, name);  // refuses what is not text
  return PovReader(bytes, name).take();
}

}  // namespace lumaknot::povray
