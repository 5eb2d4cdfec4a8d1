/// Faults to plant: each a known change of a scene, or of a finished picture, and the causes that
/// may rightly be named for it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "meshgen/knot_mesh.h"
#include "scene/image.h"
#include "scene/spec.h"

namespace lumaknot::validate {

/// A number that the cause must be named with.
struct PlantedNumber {
  std::string name;
  double value = 0;
};

struct Fault {
  std::string what;                  ///< in words, for the table
  std::vector<std::string> names{};  ///< ids of diagnosis's causes: the first, and those that can't
                                     ///< be told apart from it; empty: it must stay unknown
  std::vector<PlantedNumber> numbers{};  ///< of the first
  /// What is changed: the scene that is drawn, or else the finished picture. A scene's knot is
  /// given where it has one.
  std::function<void(Scene&, const KnotSpec*)> scene{};
  std::function<Image(const Image&)> picture{};

  /// The cause's id; what no cause describes must stay "unknown".
  std::string expected() const { return names.empty() ? "unknown" : names.front(); }
};

/// All of them that change something in `scene`.
std::vector<Fault> planted_faults(const Scene& scene, const KnotSpec* knot);

}  // namespace lumaknot::validate
