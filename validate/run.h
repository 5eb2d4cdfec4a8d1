/// The main job: one scene drawn by every renderer, compared stage by stage.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "validate/cause.h"
#include "validate/compare/claims.h"
#include "validate/compare/denoised.h"
#include "validate/compare/images.h"
#include "validate/compare/noise.h"
#include "validate/pictures.h"
#include "validate/renderers/adapter.h"

namespace lumaknot::validate {

/// What to validate.
struct ValidationJob {
  Scene scene;                         ///< image.samples must be 1; see sample_by_sample()
  std::vector<Shot> finals;            ///< the materials to draw, by name
  std::vector<std::string> renderers;  ///< flags of renderer_entries(); empty: the default ones
  Programs programs;
  Allowances allowances = {};
  std::map<std::string, Limits, std::less<>> limits = {};  ///< by the renderers' flags
  std::optional<KnotSpec> knot = {};  ///< what the scene's mesh was made from, to find causes
  bool keeps_displays = false;        ///< also fill Pictures::display
};

/// One renderer's picture of one shot, judged.
struct Judged {
  RenderedShot drawn;                      ///< its image released
  Comparison comparison;                   ///< if it was drawn
  NoiseTest noise;                         ///< if it was drawn twice with random samples
  std::optional<DenoisedErrors> denoised;  ///< if both pictures were also denoised
  Claims claims;                           ///< of final shots that were drawn without such
  Pictures pictures;  ///< if it was drawn; created while other renderers still draw
};

/// One renderer's part of the result. `shots` are in the order of Validation::shots.
struct RendererResult {
  Rendering rendering;  ///< its shots moved to `shots`
  Promise promise;      ///< of the version that drew
  Limits limits;        ///< of the user
  std::vector<Judged> shots;
  long long coverage_differs = 0;      ///< the largest of any shot: the first rung
  long long coverage_unexplained = 0;  ///< of those
  ClassShare coverage_share;           ///< of the pixels whose coverage differs for a known reason
  std::string coverage_note;           ///< what the images' coverage is like, if it is odd
  /// The first rung that differs: "placement", "coverage", "encoding" or a shot; or empty.
  std::string first_difference;
  std::vector<ClassShare> explained;  ///< beyond what is allowed: the largest share of each class
  std::string cause;  ///< the cause of its first difference, a sentence; empty if it agrees
  std::optional<Cause> found_cause;  ///< the same with its numbers

  bool drew_any() const;
  Outcome coverage_outcome() const;

  /// Of all rungs; kDiffered too if a shot failed.
  Outcome outcome() const;
};

enum class Verdict { kAgreed, kExplained, kDiffered, kNothingToCompare };

struct Validation {
  std::optional<Sampling> sampling;  ///< of the first of two pictures, if they are so drawn
  std::vector<Shot> shots;           ///< texture, diffuse, specular, then the finals
  Rendering own;
  std::vector<Claims> own_claims;        ///< of the final shots
  std::vector<OwnPicture> own_pictures;  ///< one per shot
  std::string own_cover;                 ///< see cover_png()
  std::vector<RendererResult> results;   ///< one per renderer
  double seconds = 0;                    ///< wall time of everything up to here
  Verdict verdict = Verdict::kNothingToCompare;
};

/// The stages that locate a failure's cause, then the job's final pictures.
std::vector<Shot> shots_of(const ValidationJob& job);

/// Sets the results' verdict and, for each that drew, the first rung that differs.
void conclude(Validation& validation);

/// `scene` with each of a pixel's samples x samples as a pixel of its own.
Scene sample_by_sample(Scene scene);

/// Draws the job's shots with every renderer at the same time and compares as they finish.
/// `on_message` gets a line whenever a renderer is done, one at a time. Throws Interrupted, and
/// Error if there is nothing to see.
Validation validate(const ValidationJob& job,
                    const std::function<void(const std::string&)>& on_message = {});

}  // namespace lumaknot::validate
