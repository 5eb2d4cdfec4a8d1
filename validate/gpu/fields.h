/// Reads a job's JSON; checks each value and names its path in each error.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "system/error.h"

namespace lumaknot::gpu {

using Json = nlohmann::ordered_json;

/// The members of one JSON object. Throws Error if a member is not of the kind asked for; finish()
/// throws it if there are members that were never asked for.
class Fields {
 public:
  /// `path` is the object's path, empty for the whole job.
  Fields(const Json& object, std::string path);

  bool has(std::string_view key) const { return object_.contains(key); }
  std::string text(std::string_view key);
  std::string text_or(std::string_view key, std::string otherwise);
  /// An integer from `min` to `max`.
  int integer(std::string_view key, int min, int max);
  int integer_or(std::string_view key, int min, int max, int otherwise);
  /// Numbers within the range of float; the caller checks how many.
  std::vector<float> numbers(std::string_view key);
  Fields object(std::string_view key);
  /// The objects of a list, which may be absent when `optional`.
  std::vector<Fields> objects(std::string_view key, bool optional = false);
  /// Throws Error if a member was never read.
  void finish() const;

  /// The object's path.
  const std::string& where() const { return path_; }
  /// The member's path: "draws[0].vertex".
  std::string path(std::string_view key) const;
  [[noreturn]] void fail(std::string_view key, std::string_view wanted) const;

 private:
  const Json& get(std::string_view key);

  const Json& object_;
  std::string path_;
  std::vector<std::string> known_;
};

}  // namespace lumaknot::gpu
