#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "validate/self_test/self_test.h"

namespace lumaknot::validate {
namespace {

using Json = nlohmann::ordered_json;

std::string_view noticed(const PlantedResult& r) {
  if (!r.changes) return "changes nothing";
  return r.noticed ? "yes" : "**no**";
}

std::string named(const PlantedResult& r) {
  if (!r.changes) return "";
  if (r.right) return r.sentence;
  return fmt::format("**{}**", r.named.empty() ? r.sentence : "wrong: " + r.sentence);
}

}  // namespace

std::string self_test_markdown(const SelfTest& test) {
  std::string text = fmt::format(
      "| | |\n|---|---|\n"
      "| pictures with a planted fault | {} |\n| of those that change some pixel | {} |\n"
      "| noticed | {} |\n| named with its numbers, or unknown where no cause describes it | {} "
      "|\n| unknown | {} |\n"
      "| named wrongly | {} |\n| unaltered pictures | {} |\n| of those accused | {} |\n| pictures "
      "that a renderer failed to draw | {} |\n\n"
      "| drawn by | values | planted | noticed | named |\n|---|---|---|---|---|\n",
      test.planted, test.planted - test.unseen, test.noticed, test.right, test.unknown, test.wrong,
      test.unaltered, test.accused, test.failed);
  for (const PlantedResult& r : test.results) {
    if (!r.why.empty()) {
      text += fmt::format("| {} | | {} | not drawn | {} |\n", r.drawn_by, r.fault, r.why);
    } else if (r.fault.empty()) {
      text += fmt::format("| {} | {} | nothing | {} | {} |\n", r.drawn_by, r.values,
                          r.noticed ? "**accused**" : "no", r.sentence);
    } else {
      text += fmt::format("| {} | {} | {} | {} | {} |\n", r.drawn_by, r.values, r.fault, noticed(r),
                          named(r));
    }
  }
  return text;
}

std::string self_test_json(const SelfTest& test) {
  Json results = Json::array();
  for (const PlantedResult& r : test.results) {
    results.push_back({{"fault", r.fault},
                       {"drawn_by", r.drawn_by},
                       {"values", r.values},
                       {"changes", r.changes},
                       {"noticed", r.noticed},
                       {"expected", r.expected},
                       {"named", r.named},
                       {"right", r.right},
                       {"sentence", r.sentence},
                       {"not_drawn", r.why}});
  }
  const Json json{
      {"passed", test.passed()}, {"planted", test.planted},     {"unseen", test.unseen},
      {"noticed", test.noticed}, {"right", test.right},         {"unknown", test.unknown},
      {"wrong", test.wrong},     {"unaltered", test.unaltered}, {"accused", test.accused},
      {"failed", test.failed},   {"results", results}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lumaknot::validate
