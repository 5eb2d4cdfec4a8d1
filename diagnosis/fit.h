/// Fits the numbers of hypotheses to a picture.
#pragma once

#include "diagnosis/hypothesis.h"
#include "diagnosis/score.h"

namespace lumaknot::diagnosis {

/// The picture, the scene as given, and what draws it.
struct Problem {
  const Target& target;
  const Setup& setup;
  const Drawer& drawer;
  std::size_t pixels;               ///< that count for the score
  const Problem* coarse = nullptr;  ///< the same with fewer pixels, or null
};

/// Causes that act together, in the order in which they are applied, with their numbers.
struct Explanation {
  std::vector<const Hypothesis*> causes;
  std::vector<std::vector<double>> values;  ///< of each cause
  Score score;
};

/// The scene drawn with these causes, shown as the target is.
Drawn draw(const Problem& problem, const Explanation& explanation);

/// With its score.
Explanation scored(const Problem& problem, Explanation explanation);

/// How far its mask, blurred, is from the target's.
double mask_distance(const Problem& problem, const Explanation& explanation);

/// Improves the numbers of the last `free` causes by at most `steps` steps of a robust Gauss-Newton
/// method. With `masks`, what is compared is coverage alone, blurred less and less.
Explanation fitted(const Problem& problem, Explanation explanation, std::size_t free, int steps,
                   bool masks = false);

/// Tries smaller and smaller changes of each number: out of the hollows of rough textures, in which
/// a gradient is lost.
Explanation searched_around(const Problem& problem, Explanation explanation);

}  // namespace lumaknot::diagnosis
