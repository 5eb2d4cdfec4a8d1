/// Parts of a scene's lighting that a picture might do without.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/rasterizer.h"
#include "scene/scene.h"

namespace lumaknot {

/// A scene's view and texture as far as they are simplified.
struct Lean {
  View view;
  Texture texture;
  std::vector<int> lights;  ///< of each light, its number in the scene, from 1
};

Lean whole(const Scene& scene);

/// One part that may be left out, or made simpler.
struct Simplification {
  std::string what;  ///< "light 2 left out"
  std::function<void(Lean&)> apply;
  /// How far no colour can change further than: from the least distance of a light, the largest
  /// weights and the model's largest value. None where nothing simple bounds it.
  std::optional<double> bound;
};

/// All that `lean` could do without, what saves most first. `seen` are the covered points of the
/// surface that the picture shows.
std::vector<Simplification> simplifications(const Lean& lean, std::span<const Fragment> seen);

}  // namespace lumaknot
