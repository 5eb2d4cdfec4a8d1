/// The renderers: each draws the same shots of the same scene, or says why not.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/reference.h"
#include "scene/shot.h"
#include "scene/spec.h"
#include "validate/renderers/programs.h"

namespace lumaknot::validate {

/// What became of one shot.
struct RenderedShot {
  enum class Status { kDrawn, kFailed, kSkipped };
  Status status = Status::kSkipped;
  std::string why;          ///< when it failed or was skipped: the reason and the remedy
  Image image;              ///< when it was drawn
  std::string note;         ///< how it was drawn, when not simply by the renderer
  double output_steps = 1;  ///< how many steps of the renderer's images add up in this one
  /// When the renderer can't draw the shot as it stands: the nearest one, which it drew and with
  /// which its image is to be compared.
  std::optional<Shot> instead;
};

/// What a renderer made of the shots.
struct Rendering {
  std::string renderer;
  std::string version;               ///< as the program told it; empty when it never ran
  std::vector<std::string> command;  ///< to run the same again; empty when nothing ran
  double seconds = 0;                ///< wall time of its own process
  std::string log;                   ///< what that process printed
  bool limited = false;              ///< it can't keep colours outside [0, 1]: compare limited ones
  std::vector<RenderedShot> shots;   ///< one for each asked for, in their order
};

/// Random samples, in place of one in each pixel's centre.
struct Sampling {
  int samples = 64;  ///< per pixel
  int seed = 0;      ///< of the random numbers, not negative
  bool denoised = false;
};

/// Is it here, and which one?
struct Availability {
  bool found = false;
  std::string version;
  std::string path;    ///< of the program
  std::string remedy;  ///< how to get it, when it is not found
};

/// A renderer. `draw` throws nothing but Interrupted: what goes wrong is told in the result.
class Renderer {
 public:
  virtual ~Renderer() = default;
  virtual std::string name() const = 0;
  virtual Availability availability() const = 0;
  virtual Rendering draw(const Scene& scene, std::span<const Shot> shots) const = 0;
};

/// Our own software renderer, over fragments of the scene that it is asked to draw.
std::unique_ptr<Renderer> own_renderer(const Grid<Fragment>& fragments);

/// `shots` undrawn, each for the same reason.
std::vector<RenderedShot> undrawn(std::size_t shots, RenderedShot::Status status,
                                  const std::string& why);

}  // namespace lumaknot::validate
