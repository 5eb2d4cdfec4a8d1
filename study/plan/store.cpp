#include "study/plan/store.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace lumaknot::plan {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMaxError = 1e9;  // written for infinite errors
constexpr int kIndent = 1;

Json result_json(const ToleranceResult& j) {
  return {{"error", std::min(j.error, kMaxError)},
          {"in_place", std::min(j.in_place, kMaxError)},
          {"mean_in_place", std::min(j.mean_in_place, kMaxError)},
          {"covered", j.covered},
          {"shifted", j.shifted},
          {"hidden", j.hidden},
          {"failing", j.failing},
          {"lacking", j.lacking},
          {"met", j.met}};
}

ToleranceResult result_from(const Json& json) {
  return {json.at("error"),   json.at("in_place"), json.at("mean_in_place"),
          json.at("covered"), json.at("shifted"),  json.at("hidden"),
          json.at("failing"), json.at("lacking"),  json.at("met")};
}

}  // namespace

MeasurementStore::MeasurementStore(std::filesystem::path file, std::string key)
    : checkpoint_(std::move(file), {{"key", std::move(key)}}, kIndent) {
  started_again_ = checkpoint_.load([&](const Json& json) { read(json); }).stale();
  if (!started_again_) return;
  results_.clear();
  rounds_.clear();
}

void MeasurementStore::read(const Json& json) {
  for (const auto& [name, result] : json.at("judgements").items()) {
    results_[name] = result_from(result);
  }
  for (const auto& [name, rounds] : json.at("rounds").items()) {
    for (const Json& round : rounds) rounds_[name].push_back({round.at(0), round.at(1)});
  }
}

void MeasurementStore::add(const std::string& name, const measure::FrameRound& round) {
  rounds_[name].push_back(round);
  save_at_intervals();
}

std::size_t MeasurementStore::size() const {
  std::set<std::string> names;
  for (const auto& [name, result] : results_) names.insert(name);
  for (const auto& [name, rounds] : rounds_) {
    if (!rounds.empty()) names.insert(name);
  }
  return names.size();
}

Json MeasurementStore::values() const {
  Json json{{"judgements", Json::object()}, {"rounds", Json::object()}};
  for (const auto& [name, result] : results_) {
    json["judgements"][name] = result_json(result);
  }
  for (const auto& [name, rounds] : rounds_) {
    for (const measure::FrameRound& round : rounds) {
      json["rounds"][name].push_back({round.ratio, round.milliseconds});
    }
  }
  return json;
}

void MeasurementStore::save_at_intervals() {
  checkpoint_.save_at_intervals([this] { return values(); });
}

void MeasurementStore::save() { checkpoint_.save(values()); }

}  // namespace lumaknot::plan
