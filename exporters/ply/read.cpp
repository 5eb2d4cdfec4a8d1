#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>

#include "exporters/mesh/edges.h"
#include "exporters/ply/format.h"
#include "exporters/ply/header.h"
#include "exporters/ply/values.h"
#include "exporters/text/scanner.h"

namespace lumaknot::ply {
namespace {

/// The meanings of a vertex's numbers.
enum Role : std::size_t { kX, kY, kZ, kNx, kNy, kNz, kU, kV, kRoles };

struct NamedRole {
  std::string_view name;
  Role role;
};
constexpr NamedRole kNames[] = {
    {"x", kX}, {"y", kY}, {"z", kZ}, {"nx", kNx}, {"ny", kNy},       {"nz", kNz},
    {"s", kU}, {"t", kV}, {"u", kU}, {"v", kV},   {"texture_u", kU}, {"texture_v", kV},
};

Role role_of(const PlyProperty& property) {
  for (const NamedRole& named : kNames) {
    if (!property.count && property.name == named.name) return named.role;
  }
  return kRoles;
}

bool is_indices(const PlyProperty& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

template <class Values>
class PlyReader {
 public:
  PlyReader(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : values_(bytes, name, header), header_(header) {
    polygons_.unit = Values::kUnit;
  }

  Polygons take() {
    for (const PlyElement& element : header_.elements) {
      check_count(element);
      if (element.name == "vertex") {
        vertices(element);
      } else if (element.name == "face") {
        faces(element);
      } else if (!element.properties.empty()) {
        for (std::uint64_t i = 0; i < element.count; ++i) skip(element);
      }
    }
    values_.finish();
    join();
    return std::move(polygons_);
  }

 private:
  /// Checked before allocating: whether the remaining bytes can hold so many elements.
  void check_count(const PlyElement& element) const {
    std::uint64_t min = 0;
    for (const PlyProperty& p : element.properties) {
      min += Values::min_size(p.count.value_or(p.type));
    }
    if (min == 0 || element.count <= values_.remaining() / min) return;
    values_.fail(fmt::format("the header counts {} of {}, which the file can't hold; {}",
                             element.count, in_quotes(element.name), kExportAgain));
  }

  void vertices(const PlyElement& element) {
    std::vector<Role> roles;
    std::array<bool, kRoles + 1> has{};
    for (const PlyProperty& property : element.properties) {
      roles.push_back(role_of(property));
      has[roles.back()] = true;
    }
    if (!has[kX] || !has[kY] || !has[kZ]) {
      values_.fail(fmt::format("the header gives vertices no x, y and z; {}", kExportAgain));
    }
    has_normals_ = has[kNx] && has[kNy] && has[kNz];
    has_uvs_ = has[kU] && has[kV];
    for (std::uint64_t i = 0; i < element.count; ++i) vertex(element, roles);
  }

  void vertex(const PlyElement& element, const std::vector<Role>& roles) {
    std::array<double, kRoles> value{};
    values_.begin_element();
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (roles[i] == kRoles) {
        pass(element.properties[i]);
      } else {
        value[roles[i]] = usable(values_.value(element.properties[i].type));
      }
    }
    values_.end_element();
    polygons_.positions.push_back({value[kX], value[kY], value[kZ]});
    if (has_normals_) polygons_.normals.push_back({value[kNx], value[kNy], value[kNz]});
    if (has_uvs_) polygons_.uvs.push_back({value[kU], value[kV]});
  }

  void faces(const PlyElement& element) {
    bool has_indices = false;
    for (const PlyProperty& property : element.properties) has_indices |= is_indices(property);
    if (!has_indices) {
      values_.fail(fmt::format("the header gives faces no list vertex_indices; {}", kExportAgain));
    }
    for (std::uint64_t i = 0; i < element.count; ++i) face(element);
  }

  void face(const PlyElement& element) {
    std::vector<Vec2d> uvs;
    values_.begin_element();
    const std::uint64_t place = values_.place();
    const std::size_t before = polygons_.corners.size();
    for (const PlyProperty& property : element.properties) {
      if (is_indices(property) && polygons_.corners.size() == before) {
        corners(property);
      } else if (property.count && property.name == "texcoord") {
        uvs = texture_coordinates(property);
      } else {
        pass(property);
      }
    }
    values_.end_element();
    give(uvs, before);
    polygons_.sizes.push_back(std::uint32_t(polygons_.corners.size() - before));
    polygons_.places.push_back(place);
  }

  void corners(const PlyProperty& property) {
    const std::uint64_t size = list_size(property);
    if (size < 3)
      values_.fail(fmt::format("a face of {} corners, fewer than 3; {}", size, kExportAgain));
    for (std::uint64_t i = 0; i < size; ++i) {
      const double vertex = values_.value(property.type);
      if (!(vertex >= 0 && vertex < kNoIndex && vertex == std::floor(vertex))) {
        values_.fail(fmt::format("{} is not a vertex index; {}", vertex, kExportAgain));
      }
      polygons_.corners.push_back({std::uint32_t(vertex), kNoIndex, kNoIndex});
    }
  }

  std::vector<Vec2d> texture_coordinates(const PlyProperty& property) {
    std::vector<Vec2d> uvs;
    const std::uint64_t size = list_size(property);
    if (size % 2 != 0) {
      values_.fail(fmt::format("{} numbers are not texture coordinates; {}", size, kExportAgain));
    }
    for (std::uint64_t i = 0; i < size / 2; ++i) {
      const double u = usable(values_.value(property.type));
      uvs.push_back({u, usable(values_.value(property.type))});
    }
    return uvs;
  }

  /// Gives the face's corners from `before` on their own texture coordinates, if it has any.
  void give(const std::vector<Vec2d>& uvs, std::size_t before) {
    if (uvs.empty()) return;
    const std::size_t size = polygons_.corners.size() - before;
    if (uvs.size() != size) {
      values_.fail(
          fmt::format("{} texture coordinates for {} corners; {}", uvs.size(), size, kExportAgain));
    }
    for (std::size_t i = 0; i < size; ++i) {
      polygons_.corners[before + i].uv = std::uint32_t(corner_uvs_.size());
      corner_uvs_.push_back(uvs[i]);
    }
  }

  /// Gives corners their vertices' attributes, at the end, since vertices may come after the faces.
  void join() {
    if (polygons_.uvs.size() + corner_uvs_.size() >= kNoIndex) {
      values_.fail("more than 2^32 - 2 texture coordinates, which are not read");
    }
    for (PolygonCorner& corner : polygons_.corners) {
      if (has_normals_) corner.normal = corner.position;
      if (corner.uv != kNoIndex) {
        corner.uv += std::uint32_t(polygons_.uvs.size());
      } else if (has_uvs_) {
        corner.uv = corner.position;
      }
    }
    polygons_.uvs.insert(polygons_.uvs.end(), corner_uvs_.begin(), corner_uvs_.end());
  }

  /// How many numbers follow: one, unless they are a list.
  std::uint64_t list_size(const PlyProperty& property) {
    if (!property.count) return 1;
    const double size = values_.value(*property.count);
    const std::uint64_t fitting = values_.remaining() / Values::min_size(property.type);
    const auto max = double(fitting);
    if (size >= 0 && size <= max && size == std::floor(size)) return std::uint64_t(size);
    values_.fail(
        fmt::format("a list of {} numbers, which the file can't hold; {}", size, kExportAgain));
  }

  void pass(const PlyProperty& property) {
    const std::uint64_t numbers = list_size(property);
    for (std::uint64_t i = 0; i < numbers; ++i) values_.value(property.type);
  }

  void skip(const PlyElement& element) {
    values_.begin_element();
    for (const PlyProperty& property : element.properties) pass(property);
    values_.end_element();
  }

  double usable(double value) const {
    if (is_usable(value)) return value;
    values_.fail(fmt::format("{} is not a finite float32 number; {}", value, kExportAgain));
  }

  Values values_;
  const PlyHeader& header_;
  Polygons polygons_;
  std::vector<Vec2d> corner_uvs_;  ///< from the faces' list texcoord
  bool has_normals_ = false, has_uvs_ = false;
};

}  // namespace

Polygons read(std::string_view bytes, std::string_view name) {
  const PlyHeader header = ply_header(bytes, name);
  Polygons polygons = header.encoding == PlyEncoding::kText
                          ? PlyReader<PlyText>(bytes, name, header).take()
                          : PlyReader<PlyBinary>(bytes, name, header).take();
  check_indices(polygons, name);
  return polygons;
}

}  // namespace lumaknot::ply
