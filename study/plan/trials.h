/// Methods checked against a tolerance, and timed.
#pragma once

#include <span>

#include "study/measure/method_bench.h"
#include "study/plan/candidates.h"
#include "study/plan/store.h"

namespace lumaknot::plan {

/// One scene's methods; what is measured is kept in a store.
class Trials {
 public:
  /// All are kept by reference.
  Trials(measure::MethodBench& bench, const ToleranceChecker& checker, MeasurementStore& store)
      : bench_(bench), checker_(checker), store_(store) {}

  const ToleranceResult& result(const measure::Method& method);

  /// Times the methods until each has `rounds` rounds, taking turns in each round.
  void time(std::span<const measure::Method> methods, int rounds);

  /// The median of the rounds' ratios; infinite before the first.
  double ratio(const measure::Method& method) { return ratio(measure::method_name(method)); }
  double ratio(const std::string& name);

  /// The smallest of them: a disturbed round makes no method slow.
  double min_ratio(const measure::Method& method);

  /// Milliseconds per frame: the ratio times what the baseline's frames take.
  double milliseconds(const std::string& name);

  /// Times `scene` as the reference draws it in double, as kReference.
  void time_reference(const Scene& scene, int rounds);
  static constexpr const char* kReference = "before: reference";

  /// Milliseconds per frame of the baseline.
  double baseline_milliseconds() const;

 private:
  measure::MethodBench& bench_;
  const ToleranceChecker& checker_;
  MeasurementStore& store_;
};

/// A frame of `scene` as `lumaknot render --fast` draws it, on one thread.
measure::DrawFrame fast_frame(const Scene& scene);

/// That frame as a picture.
Image fast_image(const Scene& scene);

}  // namespace lumaknot::plan
