/// A claim of the paper, compared with numbers.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lumaknot::paper {

/// A number measured for a claim and, if the claim says something about it, its bounds.
struct Measure {
  std::string what;
  double value = 0;
  std::string unit;                ///< "%", "degrees", ...; may be empty
  std::optional<double> min, max;  ///< in the same unit

  /// Whether it has a bound; without one it only accompanies the claim.
  bool is_bound() const { return min || max; }
  bool meets() const;
};

/// A number without a bound, one that must be at most `max`, at least `min`, or between them.
Measure note(std::string what, double value, std::string unit = "");
Measure at_most(std::string what, double value, double max, std::string unit = "");
Measure at_least(std::string what, double value, double min, std::string unit = "");
Measure within(std::string what, double value, double min, double max, std::string unit = "");

/// The verdict of the numbers on a claim.
enum class Ruling { kHolds, kHoldsInPart, kDoesNotHold, kNotMeasurable };

/// The paper's sections that claim something, in their order.
inline constexpr std::array<std::string_view, 5> kPaperSections{
    "1. Introduction", "2. Illumination approach using YIQ", "3. Shader implementation",
    "4. Visual appearance", "5. Performance and 6. Conclusions"};

/// One claim. `name` is letters, digits and '-'.
struct PaperClaim {
  std::string name;
  std::size_t section = 0;  ///< index of kPaperSections
  std::string says;         ///< in the paper's words if they are short
  std::string how;          ///< how the numbers were measured
  std::vector<Measure> measures;
  std::string beyond;  ///< the part that no number here can decide; may be empty
};

/// Holds if every bounded number is within its bounds, in part if some are, not if none is; not
/// measurable here if no number has a bound.
Ruling ruling_of(const PaperClaim& claim);

/// "holds", "holds in part", "does not hold" or "not measurable here".
std::string_view ruling_name(Ruling ruling);

/// Three digits, whole numbers whole and in groups: "61,440", "0.0312", "1.5e-08".
std::string figure_text(double value);

/// "3.21 %, at most 5 %", as shown on a page.
std::string value_text(const Measure& measure);
std::string bound_text(const Measure& measure);

/// The number of claims with that verdict.
long long count_of(const std::vector<PaperClaim>& claims, Ruling ruling);

}  // namespace lumaknot::paper
