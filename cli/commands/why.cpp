#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/command_table.h"
#include "cli/commands/shared_arguments.h"
#include "cli/terminal.h"
#include "system/atomic_file.h"
#include "system/error.h"
#include "validate/renderers/entry.h"

namespace lumaknot::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct WhyFlags {
  std::string cell, report = "report";
  Output out;
};

Json read_report(const std::string& folder) {
  const std::string path = (fs::path(folder) / "report.json").string();
  Json report = Json::parse(read_file(path, "--report"), nullptr, false);
  if (report.is_object() && report.contains("renderers")) return report;
  throw Error(
      fmt::format("--report {} is not a report of lumaknot validate; make one with "
                  "lumaknot validate -o {}",
                  path, folder));
}

/// The renderer's flag, as `validate --renderer` takes it.
std::string flag_of(const Json& renderer) {
  for (const validate::RendererEntry* entry : validate::renderer_entries()) {
    if (entry->name == renderer.at("renderer").get<std::string>()) return std::string(entry->flag);
  }
  return {};
}

/// The cell RENDERER/SHOT of the report that was drawn. Throws Error that lists all.
Json find_cell(const Json& report, const std::string& cell) {
  std::vector<std::string> known;
  for (const Json& renderer : report.at("renderers")) {
    for (const Json& shot : renderer.at("shots")) {
      if (!shot.contains("comparison")) continue;
      known.push_back(fmt::format("{}/{}", flag_of(renderer), shot.at("shot").get<std::string>()));
      if (known.back() == cell) return shot;
    }
  }
  throw Error(fmt::format("{} is no cell of the report; there are: {}", cell,
                          known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

void print_cell(const WhyFlags& flags, const Json& shot) {
  const Json& limits = shot.at("comparison").at("limits");
  const Json& at = limits.at("worst_at");
  flags.out.say(fmt::format("{}: {}. Nearest to its limit is the pixel ({}, {}): error {:.3g}",
                            flags.cell, shot.at("outcome").get<std::string>(), at.at(0).get<int>(),
                            at.at(1).get<int>(), limits.at("error").get<double>()));
  const double limit = limits.at("limit").get<double>();
  if (limit == 0) {
    flags.out.say("the limit was stated by --limit or --limits");
    return;
  }
  flags.out.say(fmt::format("limit {:.3g}, of", limit));
  for (const auto& [name, part] : limits.at("limit_parts").items()) {
    if (part.get<double>() > 0) {
      flags.out.say(fmt::format("  {:<20} {:.3g}", name, part.get<double>()));
    }
  }
}

int run_why(const WhyFlags& flags) {
  const Json shot = find_cell(read_report(flags.report), flags.cell);
  if (flags.out.json) fmt::print("{}\n", shot.at("comparison").at("limits").dump(2));
  print_cell(flags, shot);
  return 0;
}

}  // namespace

Subcommand why_command() {
  const auto flags = std::make_shared<WhyFlags>();
  std::vector<Argument> all{{.names = "cell",
                             .target = &flags->cell,
                             .meaning = "renderer and picture of the report: gl/specular",
                             .value = "RENDERER/SHOT",
                             .required = true},
                            {.names = "--report",
                             .target = &flags->report,
                             .meaning = "folder that lumaknot validate wrote",
                             .value = kFolder}};
  append(all, output_arguments(flags->out));
  return {.name = "why",
          .group = Group::kProve,
          .about = "Print the limit of a picture's error as the sum of its parts",
          .arguments = std::move(all),
          .notes =
              "Parts that are random (the sample's place, position, normal, texture coordinates, "
              "formula) are four standard deviations and add up by their squares.",
          .examples = {{"lumaknot why gl/specular"},
                       {"lumaknot why povray/phong --report report --json"}},
          .run = [flags] { return run_why(*flags); }};
}

}  // namespace lumaknot::cli
