/// A claim of the paper, held against numbers.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lumaknot {

/// A number taken for a claim and, where the claim says something of it, what it has to be.
struct Measure {
  std::string what;
  double value = 0;
  std::string unit;                   ///< "%", "degrees", ...; may be empty
  std::optional<double> least, most;  ///< in the same unit

  /// Neither bound: it says something beside the claim.
  bool is_bound() const { return least || most; }
  bool meets() const;
};

/// A number without a bound, one that must be at most `most`, at least `least`, or in between.
Measure note(std::string what, double value, std::string unit = "");
Measure at_most(std::string what, double value, double most, std::string unit = "");
Measure at_least(std::string what, double value, double least, std::string unit = "");
Measure within(std::string what, double value, double least, double most, std::string unit = "");

/// What the numbers say of a claim.
enum class Ruling { kHolds, kHoldsInPart, kDoesNotHold, kNotMeasurable };

/// The paper's sections that claim something, in their order.
inline constexpr std::array<std::string_view, 5> kPaperSections{
    "1. Introduction", "2. Illumination approach using YIQ", "3. Shader implementation",
    "4. Visual appearance", "5. Performance and 6. Conclusions"};

/// One claim. `name` is letters, digits and '-'.
struct PaperClaim {
  std::string name;
  std::size_t section = 0;  ///< index of kPaperSections
  std::string says;         ///< in the paper's words where they are short
  std::string how;          ///< how the numbers were taken
  std::vector<Measure> measures;
  std::string beyond;  ///< what of it no number here can decide; may be empty
};

/// Holds when every bound number is within its bounds, in part when some are, not when none is; not
/// measurable here when no number has a bound.
Ruling ruling_of(const PaperClaim& claim);

/// "holds", "holds in part", "does not hold" or "not measurable here".
std::string_view ruling_name(Ruling ruling);

/// Three digits, whole numbers whole and in groups: "61,440", "0.0312", "1.5e-08".
std::string figure_text(double value);

/// "3.21 %, at most 5 %", as a page tells it.
std::string value_text(const Measure& measure);
std::string bound_text(const Measure& measure);

/// How many claims came out so.
long long count_of(const std::vector<PaperClaim>& claims, Ruling ruling);

}  // namespace lumaknot
