/// A plan in words.
#pragma once

#include <string>
#include <vector>

#include "study/plan/outcome.h"

namespace lumaknot::plan {

/// How well a plan meets its tolerance.
enum class Verdict { kMet, kMetByShift, kNotMet };

/// A plan that needs the shift for more pixels than this share is met by the shift.
inline constexpr double kFewShifted = 0.01;

Verdict verdict_of(const Plan& plan);

/// "met", "met by the shift", "can't be met".
std::string_view verdict_name(Verdict verdict);

/// "57.4 % of the pixels in place, 42.6 % only by a shift of up to 0.25 pixels, 0.1 % not at all";
/// without the parts that are empty.
std::string shares_in_words(const ToleranceResult& result, double shift);

/// The verdict and the shares of the plan's picture.
std::string headline(const Plan& plan);

/// The same shares of the scene's own picture, and what the plan adds to them.
std::string own_picture_in_words(const Plan& plan);

/// One sentence on what is left out, and what that changes.
std::string left_out_in_words(const Plan& plan);

/// What to try if many pixels meet the tolerance only by the shift; empty for few.
std::string shift_warning(const Plan& plan);

/// A picture and how it compares with the truth.
struct PictureResult {
  std::string name;
  ToleranceResult result;
};

/// The plan's picture, and the scene's own by the reference and by --fast.
std::vector<PictureResult> picture_results(const Plan& plan);

/// "1.26 times faster than", or slower.
std::string pace_than(double before, double after);

}  // namespace lumaknot::plan
