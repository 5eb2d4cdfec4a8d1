/// The main job: one scene drawn by every renderer, compared stage by stage.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "validate/claims.h"
#include "validate/compare.h"
#include "validate/renderer.h"

namespace lumaknot {

/// What to validate.
struct ValidationJob {
  Scene scene;                         ///< image.samples must be 1; see sample_by_sample()
  std::vector<Shot> finals;            ///< the materials to draw, by name
  std::vector<std::string> renderers;  ///< from renderer_names(); empty: the usual ones
  Programs programs;
};

/// PNG files for the report, made while other renderers still draw.
struct Pictures {
  std::string theirs, difference;
  std::string ours_instead;  ///< our picture of the shot drawn in place of the one asked for
};

/// One renderer's picture of one shot, judged.
struct Judged {
  RenderedShot drawn;     ///< its image released
  Comparison comparison;  ///< when it was drawn
  Claims claims;          ///< of final shots that were drawn
  Pictures pictures;      ///< when it was drawn
};

/// One renderer's part of the result. `shots` are in the order of Validation::shots.
struct RendererResult {
  Rendering rendering;  ///< its shots moved to `shots`
  std::vector<Judged> shots;
  long long coverage_differs = 0;      ///< the most of any shot: the first rung
  long long coverage_unexplained = 0;  ///< of those
  std::string first_difference;  ///< the first rung that differs, "coverage" or a shot; or empty

  bool drew_any() const;
};

enum class Verdict { kAgreed, kDiffered, kNothingToCompare };

struct Validation {
  std::vector<Shot> shots;  ///< texture, diffuse, specular, then the finals
  Rendering own;
  std::vector<Claims> own_claims;          ///< of the final shots
  std::vector<std::string> own_pictures;   ///< PNG files, a shot each
  std::vector<RendererResult> judgements;  ///< one a renderer
  double seconds = 0;                      ///< wall time of everything up to here
  Verdict verdict = Verdict::kNothingToCompare;
};

/// The names that ValidationJob::renderers may hold: cycles, povray, eevee, gl, ...
std::vector<std::string> renderer_names();

/// One of each, in the order of their names.
std::vector<std::unique_ptr<Renderer>> all_renderers(const Programs& programs);

/// `scene` with each of its samples x samples samples a pixel made a pixel of its own.
Scene sample_by_sample(Scene scene);

/// Draws the job's shots with every renderer at the same time and compares as they finish.
/// `told` gets a line whenever a renderer is done, one at a time. Throws Interrupted, and Error
/// when there is nothing to see.
Validation validate(const ValidationJob& job,
                    const std::function<void(const std::string&)>& told = {});

}  // namespace lumaknot
