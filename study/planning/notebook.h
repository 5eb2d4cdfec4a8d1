/// What was measured, kept in a file so that a run that was stopped goes on.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/frame_time.h"
#include "study/planning/judge.h"

namespace lumaknot {

/// Judgements and times by the names of methods.
class Notebook {
 public:
  /// Reads `file`, unless it is not there or of another key.
  Notebook(std::filesystem::path file, std::string key);

  /// Whether there was a file of another key, or none that can be read.
  bool started_anew() const { return started_anew_; }

  /// What it holds under that name; what is not there is made by `measure`, and kept.
  template <class F>
  const ToleranceResult& judgement(const std::string& name, const F& measure) {
    const auto known = judgements_.find(name);
    if (known != judgements_.end()) return known->second;
    const ToleranceResult& made = judgements_.emplace(name, measure()).first->second;
    keep_at_times();
    return made;
  }

  const std::map<std::string, ToleranceResult>& judgements() const { return judgements_; }

  /// The rounds timed so far.
  const std::vector<FrameRound>& rounds(const std::string& name) { return rounds_[name]; }
  const std::map<std::string, std::vector<FrameRound>>& all_rounds() const { return rounds_; }
  void add(const std::string& name, const FrameRound& round);

  /// How many names it holds anything under.
  std::size_t size() const;

  void save();

 private:
  void read();
  void keep_at_times();

  std::filesystem::path file_;
  std::string key_;
  bool started_anew_ = false;
  std::map<std::string, ToleranceResult> judgements_;
  std::map<std::string, std::vector<FrameRound>> rounds_;
  std::chrono::steady_clock::time_point saved_ = std::chrono::steady_clock::now();
};

}  // namespace lumaknot
