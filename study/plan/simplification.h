/// The parts of a scene's lighting that a picture might not need.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/rasterizer.h"
#include "scene/spec.h"

namespace lumaknot::plan {

/// A scene's simplified view and texture.
struct SimplifiedScene {
  View view;
  Texture texture;
  std::vector<int> lights;  ///< each light's number in the scene, from 1
};

SimplifiedScene whole(const Scene& scene);

/// One part that may be left out or simplified.
struct Simplification {
  std::string what;  ///< "light 2 left out"
  std::function<void(SimplifiedScene&)> apply;
  /// The most that any colour can change by: from the smallest distance of a light, the largest
  /// weights and the model's largest value. Empty without a simple bound.
  std::optional<double> bound;
};

/// All parts that `simplified` might not need, the most expensive first. `seen` are the covered
/// points of the surface that the picture shows.
std::vector<Simplification> simplifications(const SimplifiedScene& simplified,
                                            std::span<const Fragment> seen);

}  // namespace lumaknot::plan
