/// The results a study has so far, kept in a JSON file so that an interrupted run can resume.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace lumaknot::measure {

/// The fields of a checkpoint that identify what was measured, with their values.
using CheckpointKeys = std::vector<std::pair<std::string, std::string>>;

/// The text of a checkpoint: the keys, then the fields of `values`; ends in a newline.
std::string checkpoint_text(const CheckpointKeys& keys, const nlohmann::ordered_json& values,
                            int indent = 2);

/// The result of loading a checkpoint.
struct LoadResult {
  enum class Status { kMissing, kStale, kLoaded } status = Status::kMissing;
  std::string field;  ///< stale: the key that differs; empty if the file is no checkpoint at all
  std::string found;  ///< stale: that key's value in the file, or why it could not be read

  bool loaded() const { return status == Status::kLoaded; }
  bool stale() const { return status == Status::kStale; }
};

/// Takes the results out of a checkpoint's JSON.
using ReadCheckpoint = std::function<void(const nlohmann::ordered_json& json)>;

/// As Checkpoint::load(), from `text`.
LoadResult load_checkpoint(const std::string& text, const CheckpointKeys& keys,
                           const ReadCheckpoint& read);

/// A checkpoint's file.
class Checkpoint {
 public:
  Checkpoint(std::filesystem::path file, CheckpointKeys keys, int indent = 2)
      : file_(std::move(file)), keys_(std::move(keys)), indent_(indent) {}

  /// Passes the file's JSON to `read` if it has the same keys. It is stale if one differs, if it is
  /// not JSON, or if `read` throws a JSON exception. Throws Error if the file can't be read.
  LoadResult load(const ReadCheckpoint& read) const;

  /// Writes the keys and the fields of `values`. Throws Error.
  void save(const nlohmann::ordered_json& values);

  /// Saves if more than a second has passed since the last time, or since this was constructed.
  void save_at_intervals(const std::function<nlohmann::ordered_json()>& values);

 private:
  std::filesystem::path file_;
  CheckpointKeys keys_;
  int indent_;
  std::chrono::steady_clock::time_point saved_ = std::chrono::steady_clock::now();
};

}  // namespace lumaknot::measure
