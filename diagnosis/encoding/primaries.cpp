/// Colours of other primaries than sRGB's.
#include <fmt/format.h>

#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

namespace {

Rows transposed(const Rows& m) {
  return {{{m[0].x, m[1].x, m[2].x}, {m[0].y, m[1].y, m[2].y}, {m[0].z, m[1].z, m[2].z}}};
}

Rows product(const Rows& a, const Rows& b) {
  const Rows columns = transposed(b);
  return transposed({{a * columns[0], a * columns[1], a * columns[2]}});
}

Rows inverse(const Rows& m) {
  const double determinant = dot(m[0], cross(m[1], m[2]));
  return transposed({{cross(m[1], m[2]) / determinant, cross(m[2], m[0]) / determinant,
                      cross(m[0], m[1]) / determinant}});
}

/// CIE x and y.
struct Chromaticity {
  double x, y;
  Vec3d xyz() const { return {x / y, 1, (1 - x - y) / y}; }
};

struct ColorSpace {
  std::string_view id, name;
  Chromaticity red, green, blue, white;
};

constexpr Chromaticity kD65{0.3127, 0.3290};
constexpr ColorSpace kSrgb{"srgb", "sRGB", {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, kD65};
constexpr std::array<ColorSpace, 3> kOthers{
    {{"rec2020", "Rec. 2020", {0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, kD65},
     {"p3", "Display P3", {0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, kD65},
     {"acescg", "ACEScg", {0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}}}};

/// Bradford's change of the white point.
Rows adapted(const Chromaticity& from, const Chromaticity& to) {
  constexpr Rows kCones{
      {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
  const Vec3d a = kCones * from.xyz(), b = kCones * to.xyz();
  const Rows scale{{{b.x / a.x, 0, 0}, {0, b.y / a.y, 0}, {0, 0, b.z / a.z}}};
  return product(inverse(kCones), product(scale, kCones));
}

/// From the space's RGB to XYZ over D65.
Rows to_xyz(const ColorSpace& space) {
  const Rows columns = transposed({{space.red.xyz(), space.green.xyz(), space.blue.xyz()}});
  const Vec3d s = inverse(columns) * space.white.xyz();
  const Rows scale{{{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}}};
  return product(adapted(space.white, kD65), product(columns, scale));
}

}  // namespace

std::vector<Hypothesis> primaries(const Situation&) {
  std::vector<Hypothesis> all;
  const auto add = [&](std::string id, std::string sentence, const Rows& rows) {
    all.push_back(discrete(std::move(id), Rung::kEncoding, std::move(sentence),
                           [rows](Setup& s) { s.color.primaries = rows; }));
  };
  for (const ColorSpace& space : kOthers) {
    const Rows stored = product(inverse(to_xyz(space)), to_xyz(kSrgb));
    add(fmt::format("primaries-{}", space.id), fmt::format("colours in {}", space.name), stored);
    add(fmt::format("primaries-{}-taken", space.id),
        fmt::format("its colours taken for those of {}", space.name), inverse(stored));
  }
  return all;
}

}  // namespace lumaknot::diagnosis
