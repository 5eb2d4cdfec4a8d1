#include "study/measure/checkpoint.h"

#include <nlohmann/json.hpp>

#include "system/atomic_file.h"

namespace lumaknot::measure {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kOutputFlag = "--output";
constexpr std::chrono::seconds kInterval{1};

}  // namespace

std::string checkpoint_text(const CheckpointKeys& keys, const Json& values, int indent) {
  Json json = Json::object();
  for (const auto& [field, value] : keys) json[field] = value;
  for (const auto& [field, value] : values.items()) json[field] = value;
  return json.dump(indent) + "\n";
}

LoadResult load_checkpoint(const std::string& text, const CheckpointKeys& keys,
                           const ReadCheckpoint& read) {
  using Status = LoadResult::Status;
  try {
    const Json json = Json::parse(text);
    for (const auto& [field, value] : keys) {
      const std::string found = json.at(field);
      if (found != value) return {Status::kStale, field, found};
    }
    read(json);
    return {Status::kLoaded, {}, {}};
  } catch (const Json::exception& e) {
    return {Status::kStale, {}, e.what()};
  }
}

LoadResult Checkpoint::load(const ReadCheckpoint& read) const {
  std::error_code ignored;
  if (!std::filesystem::exists(file_, ignored)) return {};
  return load_checkpoint(read_file(file_, kOutputFlag), keys_, read);
}

void Checkpoint::save(const Json& values) {
  write_file(file_, checkpoint_text(keys_, values, indent_), kOutputFlag);
  saved_ = std::chrono::steady_clock::now();
}

void Checkpoint::save_at_intervals(const std::function<Json()>& values) {
  if (std::chrono::steady_clock::now() - saved_ > kInterval) save(values());
}

}  // namespace lumaknot::measure
