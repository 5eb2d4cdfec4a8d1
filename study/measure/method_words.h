/// Methods in words, for readers; method_name() is for files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/measure/method.h"
#include "validate/report/page_kit.h"

namespace lumaknot::measure {

/// "grid 369 x 48, light per pixel in RGB, float, bilinear texture, 1 sample per pixel, back faces
/// culled".
std::string method_words(const Method& method);

/// One of those words, and what it means.
struct MethodTerm {
  std::string_view word, meaning;
};

/// All words that method_words() uses, in its order.
const std::vector<MethodTerm>& method_legend();

/// Them as a page's rows: `word` and `meaning`.
validate::PageData method_legend_rows();

}  // namespace lumaknot::measure
