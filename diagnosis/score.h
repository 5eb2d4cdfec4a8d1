/// How well a drawn picture explains the target.
#pragma once

#include "diagnosis/target.h"

namespace lumaknot::diagnosis {

struct Score {
  double value = 0;             ///< mean of log(1 + (error / noise)^2) over the pixels that count
  double explained = 0;         ///< share of them with an error of at most four times the noise
  double median = 0, p999 = 0;  ///< of their errors
};

/// A pixel's error: the largest difference of its channels and, with alpha, of its coverage.
std::vector<double> errors_of(const Target& target, const Drawn& ours);

/// `pixels`: how many count, the covered ones of the target or of ours.
Score score_of(const Target& target, std::vector<double> errors, std::size_t pixels);

}  // namespace lumaknot::diagnosis
