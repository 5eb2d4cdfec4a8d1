/// Which pictures POV-Ray draws so that every shot it can show is shown.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/shot.h"
#include "scene/spec.h"

namespace lumaknot::validate {

/// The pictures that a shot is composed from, by index into PovPlan::frames.
struct PovParts {
  std::size_t texture = 0;
  std::optional<std::size_t> diffuse, specular;  ///< nothing: the shot does not need it
  double brightness = 1;  ///< what the light in those two was divided by, to fit into [0, 1]
};

/// How one shot comes about.
struct PovShot {
  std::optional<std::size_t> frame;  ///< drawn by POV-Ray's own lighting: index into frames
  std::optional<PovParts> parts;     ///< else composed
  std::string why;                   ///< why not drawn; with neither, why skipped
};

/// What to draw. Shots that look the same share a frame.
struct PovPlan {
  std::vector<std::string> frames;  ///< scenes
  std::vector<PovShot> shots;       ///< in the order asked for
};

/// `prefix` and `mesh`: as pov_scene() has them.
PovPlan plan_povray(const Scene& scene, std::span<const Shot> shots, const std::string& prefix,
                    std::string_view mesh);

/// An upper bound of L_D's and L_S's channels on the mesh in Lambert's, Phong's and Blinn's models.
double brightest_light(const TriangleMesh& mesh, const View& view, Space space);

}  // namespace lumaknot::validate
