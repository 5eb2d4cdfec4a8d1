/// Where the error of one image comes from.
#pragma once

#include <string>
#include <vector>

#include "render/render.h"
#include "scene/scene.h"
#include "study/error_map.h"

namespace lumaknot {

/// One stage of the method and the error that it makes.
struct BudgetPart {
  std::string name;
  std::string exact;  ///< what its exact form is
  double rmse = 0, max = 0;
  ErrorMap map;
};

/// An image's error by stage. Root mean squares are of all channels of the pixels that the image or
/// the truth covers.
struct ErrorBudget {
  std::vector<BudgetPart> parts;
  BudgetPart whole;        ///< the picture minus the truth
  BudgetPart left;         ///< the whole minus all parts: how stages act on each other
  long long pixels = 0;    ///< covered
  double truth_error = 0;  ///< estimated, root mean square of the truth's pixels

  double share_left() const { return whole.rmse > 0 ? left.rmse / whole.rmse : 0; }
};

struct BudgetOptions {
  int samples = 4;                ///< samples x samples a pixel, for what is averaged in the method
  double tolerance = 1.0 / 1024;  ///< of the truth's pixels
};

/// The budget of the fast renderer's picture of `scene`, whose mesh is knot_mesh(knot): one sample
/// a pixel, bilinear texture, float, 8 bits.
///
/// Each stage is swapped alone: the method's picture minus the same with the stage exact, and the
/// truth with the stage as the method has it minus the truth; a part is the mean of both, pixel by
/// pixel. Where two stages act on each other, each has half of what they do; of three it is not all
/// found. So parts need not add up, and `left` tells whether they do. Arithmetic, clamp and
/// quantisation come last in the method and are taken there, one after the other. The truth that
/// the whole is held to is another than the one that is swapped in: draw_truth()'s mean over each
/// pixel, not limited to [0, 1], its colours by the collapsed form in linear spaces. Throws Error
/// where there is no exact surface, more than one sample a pixel, and light a vertex.
ErrorBudget error_budget(const Scene& scene, const KnotSpec& knot,
                         const BudgetOptions& options = {}, const Progress& progress = {});

std::string budget_text(const ErrorBudget& budget);
std::string budget_json(const ErrorBudget& budget);

/// The whole, each part and what is left, side by side in the table's order, four a row: |error| x
/// 16.
Image budget_picture(const ErrorBudget& budget);

}  // namespace lumaknot
