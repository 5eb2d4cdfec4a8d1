/// Where the error of one image comes from.
#pragma once

#include <string>
#include <vector>

#include "render/reference.h"
#include "scene/spec.h"
#include "study/measure/error_map.h"

namespace lumaknot::budget {

/// One stage of the method and the error it causes.
struct BudgetPart {
  std::string name;
  std::string exact;  ///< what its exact form is
  double rmse = 0, max = 0;
  measure::ErrorMap map;
};

/// An image's error by stage. Root mean squares are of all channels of the pixels that the image or
/// the truth covers.
struct ErrorBudget {
  std::vector<BudgetPart> parts;
  BudgetPart whole;        ///< the picture minus the truth
  BudgetPart left;         ///< the whole minus all parts: how stages interact
  long long pixels = 0;    ///< covered
  double truth_error = 0;  ///< estimated, root mean square of the truth's pixels

  double share_left() const { return whole.rmse > 0 ? left.rmse / whole.rmse : 0; }
};

struct BudgetOptions {
  int samples = 4;                ///< samples x samples per pixel, for what the method averages
  double tolerance = 1.0 / 1024;  ///< of the truth's pixels
};

/// The budget of the fast renderer's picture of `scene`, whose mesh is knot_mesh(knot): one sample
/// per pixel, bilinear texture, float, 8 bits.
///
/// Each stage is swapped by itself: the method's picture minus the same with the stage exact, and
/// the truth with the method's stage minus the truth; a part is the mean of both, pixel by pixel.
/// Where two stages interact, each gets half of the effect; between three, part of it is not found.
/// So parts need not add up; `left` shows whether they do. Arithmetic, clamp and quantisation come
/// last in the method and are measured there, one after the other. The truth that the whole is
/// compared with is not the one that is swapped in: it is draw_truth()'s mean over each pixel, not
/// limited to [0, 1], its colours by the collapsed form in linear spaces. Throws Error if there is
/// no exact surface, more than one sample per pixel, or lighting per vertex.
ErrorBudget error_budget(const Scene& scene, const KnotSpec& knot,
                         const BudgetOptions& options = {}, const Progress& progress = {});

std::string budget_text(const ErrorBudget& budget);
std::string budget_json(const ErrorBudget& budget);

/// The whole, each part and what is left, side by side in the table's order, four per row: |error|
/// x 16.
Image budget_picture(const ErrorBudget& budget);

}  // namespace lumaknot::budget
