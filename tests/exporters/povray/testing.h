/// Shared by the tests of POV-Ray scenes.
#pragma once

#include <regex>

#include "exporters/povray/scene.h"
#include "tests/exporters/testing.h"

namespace lumaknot::testing {

inline const std::string kNumber = R"((-?[0-9.]+(?:e[-+]?[0-9]+)?))";
inline const std::string kVector = "<" + kNumber + ", " + kNumber + ", " + kNumber + ">";
inline const std::string kColor = "rgb (?:" + kVector + "|" + kNumber + ")";  ///< four groups

inline std::string scene_text(const Scene& scene, Stage stage, const Material& m) {
  return povray::pov_scene(scene.view, scene.texture, {"shot", stage, m}, "", "MESH\n");
}

/// The groups of a match, empty if one took no part; the whole match first.
using Match = std::vector<std::string>;

inline std::vector<Match> matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<Match> all;
  for (std::sregex_iterator m(text.begin(), text.end(), expression), end; m != end; ++m) {
    Match& groups = all.emplace_back();
    for (const auto& group : *m) groups.push_back(group.str());
  }
  return all;
}

inline Vec3d vector_of(const Match& match, std::size_t first = 1) {
  return {std::stod(match[first]), std::stod(match[first + 1]), std::stod(match[first + 2])};
}

/// The colour in the four groups of kColor; black if absent.
inline Vec3d color_of(const Match& match, std::size_t first = 1) {
  if (!match[first].empty()) return vector_of(match, first);
  const double grey = match[first + 3].empty() ? 0 : std::stod(match[first + 3]);
  return {grey, grey, grey};
}

inline void expect_near(const Vec3d& a, const Vec3d& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

}  // namespace lumaknot::testing
