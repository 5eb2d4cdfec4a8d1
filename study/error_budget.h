/// Where the error of one image comes from.
#pragma once

#include <string>
#include <vector>

#include "render/render.h"
#include "scene/scene.h"

namespace lumaknot {

/// Differences of a picture's channels from another's, signed.
using ErrorMap = Grid<Vec3d>;

/// One stage of the method, and the error that it makes: the method's picture minus the same with
/// this stage alone exact.
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
  double centre = 0;       ///< the geometry's error at pixel centres, texture and all else as is
  double centre_left = 0;  ///< what its parts leave of it
  long long pixels = 0;    ///< covered
  double truth_error = 0;  ///< estimated, root mean square of the truth's pixels

  double share_left() const { return whole.rmse > 0 ? left.rmse / whole.rmse : 0; }
  double centre_share_left() const { return centre > 0 ? centre_left / centre : 0; }
};

struct BudgetOptions {
  int samples = 6;                ///< samples x samples a pixel, for what is averaged in the method
  double tolerance = 1.0 / 1024;  ///< of the truth's pixels
};

/// The budget of the fast renderer's picture of `scene`, whose mesh is knot_mesh(knot): one sample
/// a pixel, bilinear texture, float, 8 bits. Of a stage measured by itself in the method the
/// others' errors are unchanged, so that the parts need not add up: `left` tells whether they do.
/// The truth is draw_truth()'s mean over each pixel, not limited to [0, 1], its colours by the
/// collapsed form in linear spaces. Throws Error where there is no exact surface, more than one
/// sample a pixel, and light a vertex.
ErrorBudget error_budget(const Scene& scene, const KnotSpec& knot,
                         const BudgetOptions& options = {}, const Progress& progress = {});

std::string budget_text(const ErrorBudget& budget);
std::string budget_json(const ErrorBudget& budget);

/// The whole, each part and what is left, side by side in the table's order, four a row: |error| x
/// 16.
Image budget_picture(const ErrorBudget& budget);

}  // namespace lumaknot
