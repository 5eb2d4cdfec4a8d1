/// Measurements of methods, kept in a file so that an interrupted run can resume.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "study/measure/checkpoint.h"
#include "study/measure/frame_time.h"
#include "study/plan/verifier.h"

namespace lumaknot::plan {

/// Tolerance results and times by the names of methods.
class MeasurementStore {
 public:
  /// Reads `file`, unless it is missing or has another key.
  MeasurementStore(std::filesystem::path file, std::string key);

  /// Whether there was a file with another key, or one that can't be parsed.
  bool started_again() const { return started_again_; }

  /// The result under that name; if absent it is computed by `measure`, and kept.
  template <class F>
  const ToleranceResult& result(const std::string& name, const F& measure) {
    const auto known = results_.find(name);
    if (known != results_.end()) return known->second;
    const ToleranceResult& made = results_.emplace(name, measure()).first->second;
    save_at_intervals();
    return made;
  }

  const std::map<std::string, ToleranceResult>& results() const { return results_; }

  /// The rounds timed so far.
  const std::vector<measure::FrameRound>& rounds(const std::string& name) { return rounds_[name]; }
  const std::map<std::string, std::vector<measure::FrameRound>>& all_rounds() const {
    return rounds_;
  }
  void add(const std::string& name, const measure::FrameRound& round);

  /// The number of names with a result or a round.
  std::size_t size() const;

  void save();

 private:
  void read(const nlohmann::ordered_json& json);
  nlohmann::ordered_json values() const;
  void save_at_intervals();

  measure::Checkpoint checkpoint_;
  bool started_again_ = false;
  std::map<std::string, ToleranceResult> results_;
  std::map<std::string, std::vector<measure::FrameRound>> rounds_;
};

}  // namespace lumaknot::plan
