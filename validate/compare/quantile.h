/// Quantiles of errors.
#pragma once

#include <vector>

namespace lumaknot::validate {

/// The smallest of `values` that `share` of them don't exceed, share in (0, 1]; 0 without values.
double quantile(std::vector<double> values, double share);

}  // namespace lumaknot::validate
