/// Methods drawn and timed.
#pragma once

#include <map>
#include <utility>

#include "scene/image.h"
#include "scene/spec.h"
#include "study/measure/frame_time.h"
#include "study/measure/method.h"

namespace lumaknot::measure {

/// One scene's methods.
class MethodBench {
 public:
  /// Creates what draws the frames that others are timed against.
  using MakeBaseline = std::function<DrawFrame()>;

  /// `mesh` is what the scene's own mesh was built from. The first round calls `make_baseline`.
  MethodBench(Scene scene, MeshSpec mesh, MakeBaseline make_baseline)
      : scene_(std::move(scene)),
        mesh_(std::move(mesh)),
        make_baseline_(std::move(make_baseline)) {}

  /// The scene with the method's mesh; valid until the next call for a method.
  const Scene& scene_of(const Method& method);

  Image draw(const Method& method);

  /// Times the method, or `frame`, for one round. The method's renderer is created for it: where
  /// its memory is affects its time.
  FrameRound time(const Method& method);
  FrameRound time(const DrawFrame& frame);

 private:
  Scene scene_;
  MeshSpec mesh_;
  MakeBaseline make_baseline_;
  DrawFrame baseline_;  ///< empty before the first round
  std::map<std::pair<int, int>, Scene> scenes_;
};

}  // namespace lumaknot::measure
