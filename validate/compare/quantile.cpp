#include "validate/compare/quantile.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lumaknot::validate {

double quantile(std::vector<double> values, double share) {
  assert(share > 0 && share <= 1);
  if (values.empty()) return 0;
  const double rank = std::ceil(share * double(values.size()));
  const auto place = values.begin() + std::ptrdiff_t(std::max(rank, 1.0)) - 1;
  std::ranges::nth_element(values, place);
  return *place;
}

}  // namespace lumaknot::validate
