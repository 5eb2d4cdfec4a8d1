/// Linear least squares of a few unknowns.
#pragma once

#include <vector>

namespace lumaknot::diagnosis {

/// The x of A x = b, where A is symmetric and positive (n x n, row by row) with `damping` times its
/// diagonal added; zero where A is singular.
std::vector<double> solve(std::vector<double> a, std::vector<double> b, double damping);

}  // namespace lumaknot::diagnosis
