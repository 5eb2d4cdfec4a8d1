#include "study/stability/atlas_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

#include "study/measure/checkpoint.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "system/version.h"

namespace lumaknot::stability {
namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

double number_of(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Json pair(const Measured& m) { return {number(m.x), number(m.error)}; }

Measured pair_of(const Json& json) { return {number_of(json.at(0)), number_of(json.at(1))}; }

Json pairs(const std::vector<Measured>& all) {
  Json list = Json::array();
  for (const Measured& m : all) list.push_back(pair(m));
  return list;
}

std::vector<Measured> pairs_of(const Json& json) {
  std::vector<Measured> all;
  for (const Json& each : json) all.push_back(pair_of(each));
  return all;
}

/// The texts of an entry, by their keys.
template <class E>
auto texts_of(E& e) {
  return std::array{std::pair{"name", &e.name},        std::pair{"group", &e.group},
                    std::pair{"method", &e.method},    std::pair{"reason", &e.reason},
                    std::pair{"remedy", &e.remedy},    std::pair{"parameter", &e.parameter},
                    std::pair{"measured", &e.measured}};
}

Json entry_json(const Entry& e) {
  Json json;
  for (const auto& [key, text] : texts_of(e)) json[key] = *text;
  json["limit"] = e.limit;
  json["holds"] = pair(e.boundary.holds);
  json["fails"] = pair(e.boundary.fails);
  json["holds_again"] = Json::array();
  for (const SweepInterval& s : holding_again(e)) json["holds_again"].push_back({s.from, s.to});
  json["remedy_worst"] = number(e.guarded_worst);
  json["sweep"] = pairs(e.sweep);
  json["remedy_sweep"] = pairs(e.guarded);
  json["also"] = Json::array();
  for (const AlsoMeasured& a : e.also) {
    json["also"].push_back({{"name", a.name},
                            {"holds", number(a.holds)},
                            {"boundary", {number(a.last_holding), number(a.first_failing)}},
                            {"fails", number(a.fails)}});
  }
  json["pictures"] = Json::array();
  for (const Picture& p : e.pictures) {
    json["pictures"].push_back({{"caption", p.caption}, {"file", p.file}});
  }
  return json;
}

Entry entry_of(const Json& json, const std::filesystem::path& folder) {
  Entry e;
  for (const auto& [key, text] : texts_of(e)) *text = json.at(key);
  e.limit = json.at("limit");
  e.boundary = {pair_of(json.at("holds")), pair_of(json.at("fails"))};
  e.guarded_worst = number_of(json.at("remedy_worst"));
  e.sweep = pairs_of(json.at("sweep"));
  e.guarded = pairs_of(json.at("remedy_sweep"));
  for (const Json& a : json.at("also")) {
    const Json& boundary = a.at("boundary");
    e.also.push_back({a.at("name"), number_of(a.at("holds")), number_of(boundary.at(0)),
                      number_of(boundary.at(1)), number_of(a.at("fails"))});
  }
  for (const Json& p : json.at("pictures")) {
    const std::string file = p.at("file");
    e.pictures.push_back({p.at("caption"), file, read_file(folder / e.name / file, "--output")});
  }
  return e;
}

bool has_pictures(const Json& region, const std::filesystem::path& folder) {
  const std::string name = region.at("name");
  return std::ranges::all_of(region.at("pictures"), [&](const Json& picture) {
    return std::filesystem::exists(folder / name / std::string(picture.at("file")));
  });
}

Json energies_json(const std::vector<Energy>& energies) {
  Json list = Json::array();
  for (const Energy& e : energies) {
    list.push_back(
        {{"term", e.term},
         {"most", e.max},
         {"at_degrees", e.at_degrees < 0 ? Json(nullptr) : Json(e.at_degrees)},
         {"above_degrees", e.above_degrees < 0 ? Json(nullptr) : Json(e.above_degrees)}});
  }
  return list;
}

measure::CheckpointKeys atlas_keys() { return {{"version", std::string(version())}}; }

Json atlas_values(const Atlas& atlas) {
  Json json;
  json["regions"] = Json::array();
  for (const Entry& e : atlas.entries) json["regions"].push_back(entry_json(e));
  json["energies"] = energies_json(atlas.energies);
  return json;
}

Atlas atlas_from(const Json& json, const std::filesystem::path& folder) {
  Atlas atlas;
  for (const Json& region : json.at("regions")) {
    if (has_pictures(region, folder)) atlas.entries.push_back(entry_of(region, folder));
  }
  for (const Json& e : json.at("energies")) {
    const auto angle = [&](const char* key) {
      return e.at(key).is_null() ? -1 : e.at(key).get<double>();
    };
    atlas.energies.push_back(
        {e.at("term"), e.at("most"), angle("at_degrees"), angle("above_degrees")});
  }
  return atlas;
}

/// `x` with `digits` digits, rounded up or down.
std::string rounded(double x, int digits, bool up) {
  std::string nearest = fmt::format("{:.{}g}", x, digits);
  const double value = std::strtod(nearest.c_str(), nullptr);
  if (up ? value >= x : value <= x) return nearest;
  const double step = std::pow(10, std::floor(std::log10(std::abs(x))) + 1 - digits);
  return fmt::format("{:.{}g}", up ? value + step : value - step, digits);
}

std::string energy_line(const Energy& e) {
  const std::string at =
      e.at_degrees < 0 ? "at every angle" : fmt::format("at {:2.0f} degrees", e.at_degrees);
  return fmt::format("{:<38} {:>9.4g} {:<14}  {}\n", e.term, e.max, at,
                     e.above_degrees < 0
                         ? "never above 1"
                         : fmt::format("above 1 from {} degrees on", e.above_degrees));
}

}  // namespace

std::string boundary_text(const Boundary& b) {
  const bool rising = b.fails.x > b.holds.x;
  const double apart = std::abs(b.fails.x - b.holds.x);
  for (int digits = 3; digits < 17; ++digits) {
    const std::string holds = rounded(b.holds.x, digits, !rising);
    const std::string fails = rounded(b.fails.x, digits, rising);
    const auto is_near = [&](const std::string& text, double x) {
      return std::abs(std::strtod(text.c_str(), nullptr) - x) <= apart;
    };
    if (is_near(holds, b.holds.x) && is_near(fails, b.fails.x)) {
      return fmt::format("{} -> {}", holds, fails);
    }
  }
  return fmt::format("{} -> {}", b.holds.x, b.fails.x);
}

std::string again_text(const Entry& entry) {
  constexpr int kDigits = 4;
  std::string text;
  for (const SweepInterval& s : holding_again(entry)) {
    text += text.empty() ? "holds again " : " and ";
    const bool rising = s.to > s.from;
    text += s.from == s.to ? fmt::format("at {:.{}g}", s.from, kDigits)
                           : fmt::format("from {} to {}", rounded(s.from, kDigits, rising),
                                         rounded(s.to, kDigits, !rising));
  }
  return text;
}

std::string atlas_text(const Atlas& atlas) {
  std::string text;
  std::string_view group;
  for (const Entry& e : atlas.entries) {
    if (e.group != group) text += fmt::format("{}{}\n", text.empty() ? "" : "\n", e.group);
    group = e.group;
    const std::string again = again_text(e);
    text += fmt::format("  {:<25} {:<27} {}{}{}\n", e.name, boundary_text(e.boundary), e.parameter,
                        again.empty() ? "" : "; ", again);
  }
  if (atlas.energies.empty()) return text;
  text += "\nEnergy: the most that comes back of the light that arrives\n";
  for (const Energy& e : atlas.energies) text += "  " + energy_line(e);
  return text;
}

std::string atlas_json(const Atlas& atlas) {
  return measure::checkpoint_text(atlas_keys(), atlas_values(atlas));
}

Atlas read_atlas(const std::string& text, const std::filesystem::path& folder,
                 std::string_view label) {
  Atlas atlas;
  const measure::LoadResult result = measure::load_checkpoint(
      text, atlas_keys(), [&](const Json& json) { atlas = atlas_from(json, folder); });
  if (result.loaded()) return atlas;
  if (result.field.empty()) {
    throw Error(fmt::format("{} is not an atlas ({}); remove it, or give another folder", label,
                            result.found));
  }
  throw Error(fmt::format("{} is by lumaknot {} and this is {}; remove it, or give another folder",
                          label, result.found, version()));
}

}  // namespace lumaknot::stability
