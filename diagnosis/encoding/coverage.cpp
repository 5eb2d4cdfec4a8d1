/// Colours multiplied by, or divided by, their coverage once too often.
#include "diagnosis/cause.h"

namespace lumaknot::diagnosis {

std::vector<Hypothesis> coverage(const Situation& situation) {
  if (!situation.soft_edges) return {};
  return {discrete("alpha-twice", Rung::kEncoding, "its colours multiplied by alpha twice",
                   [](Setup& s) { s.color.by_alpha = 1; }),
          discrete("alpha-straight", Rung::kEncoding, "its colours not multiplied by alpha",
                   [](Setup& s) { s.color.by_alpha = -1; })};
}

}  // namespace lumaknot::diagnosis
