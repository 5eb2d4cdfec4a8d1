#include "study/planning/notebook.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "scene/atomic_file.h"

namespace lumaknot {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMostError = 1e9;  // what is no number is kept as this

Json kept_json(const ToleranceResult& j) {
  return {{"error", std::min(j.error, kMostError)},
          {"in_place", std::min(j.in_place, kMostError)},
          {"mean_in_place", std::min(j.mean_in_place, kMostError)},
          {"covered", j.covered},
          {"shifted", j.shifted},
          {"hidden", j.hidden},
          {"failing", j.failing},
          {"met", j.met}};
}

ToleranceResult judgement_from(const Json& json) {
  return {json.at("error"),   json.at("in_place"), json.at("mean_in_place"), json.at("covered"),
          json.at("shifted"), json.at("hidden"),   json.at("failing"),       json.at("met")};
}

}  // namespace

Notebook::Notebook(std::filesystem::path file, std::string key)
    : file_(std::move(file)), key_(std::move(key)) {
  std::error_code ignored;
  if (!std::filesystem::exists(file_, ignored)) return;
  try {
    read();
  } catch (const Json::exception&) {
    started_anew_ = true;
  }
  if (!started_anew_) return;
  judgements_.clear();
  rounds_.clear();
}

void Notebook::read() {
  const Json json = Json::parse(read_file(file_, "measured.json"));
  started_anew_ = json.at("key") != key_;
  if (started_anew_) return;
  for (const auto& [name, judgement] : json.at("judgements").items()) {
    judgements_[name] = judgement_from(judgement);
  }
  for (const auto& [name, rounds] : json.at("rounds").items()) {
    for (const Json& round : rounds) rounds_[name].push_back({round.at(0), round.at(1)});
  }
}

void Notebook::add(const std::string& name, const FrameRound& round) {
  rounds_[name].push_back(round);
  keep_at_times();
}

std::size_t Notebook::size() const {
  std::set<std::string> names;
  for (const auto& [name, judgement] : judgements_) names.insert(name);
  for (const auto& [name, rounds] : rounds_) {
    if (!rounds.empty()) names.insert(name);
  }
  return names.size();
}

void Notebook::keep_at_times() {
  if (std::chrono::steady_clock::now() - saved_ > std::chrono::seconds(1)) save();
}

void Notebook::save() {
  Json json{{"key", key_}, {"judgements", Json::object()}, {"rounds", Json::object()}};
  for (const auto& [name, judgement] : judgements_) {
    json["judgements"][name] = kept_json(judgement);
  }
  for (const auto& [name, rounds] : rounds_) {
    for (const FrameRound& round : rounds) {
      json["rounds"][name].push_back({round.ratio, round.milliseconds});
    }
  }
  write_file(file_, json.dump(1) + "\n", "--output");
  saved_ = std::chrono::steady_clock::now();
}

}  // namespace lumaknot
