#include "cli/shader_list.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scene/fields.h"
#include "scene/presets.h"
#include "shaders/emit.h"

namespace lumaknot {
namespace {

ShaderJob job_of(const std::string& name, Rate rate) {
  ShaderJob job;
  job.name = name;
  job.shot = {"final", Stage::kFinal, *with_formula(job.view.material, name)};
  job.shot.material.rate = rate;
  return job;
}

/// "yes", "pixel" where light can't be computed a vertex, or "no".
std::string_view cell(const std::string& name, Language language) {
  if (emission_shortfall(job_of(name, Rate::kPixel), language)) return "no";
  return emission_shortfall(job_of(name, Rate::kVertex), language) ? "pixel" : "yes";
}

}  // namespace

std::string shader_list_text() {
  std::string text = fmt::format("{:<28} {:>4}", "shader", "ops");
  for (const LanguageInfo& info : kLanguages) text += fmt::format("  {}", info.name);
  text += "\n";
  for (const std::string& name : formula_names()) {
    const int operations = operation_count(make_shader(job_of(name, Rate::kPixel)));
    text += fmt::format("{:<28} {:>4}", name, operations);
    for (const LanguageInfo& info : kLanguages) {
      text += fmt::format("  {:<{}}", cell(name, info.language), info.name.size());
    }
    while (text.ends_with(' ')) text.pop_back();
    text += "\n";
  }
  return text +
         "\nops: operations a pixel with one white point light. yes: light a pixel or a vertex.\n"
         "pixel: --rate vertex is not possible, as the language has no vertex stage.\n"
         "Every shader takes --light, --gamut and --gated.\n";
}

std::string shader_list_json() {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const std::string& name : formula_names()) {
    for (const Rate rate : {Rate::kPixel, Rate::kVertex}) {
      const ShaderJob job = job_of(name, rate);
      Json entry{{"shader", name},
                 {"rate", kRateNames[std::size_t(rate)]},
                 {"operations", operation_count(make_shader(job))},
                 {"languages", Json::array()},
                 {"impossible", Json::object()}};
      for (const LanguageInfo& info : kLanguages) {
        const auto why = emission_shortfall(job, info.language);
        if (why) entry["impossible"][std::string(info.name)] = *why;
        if (!why) entry["languages"].push_back(info.name);
      }
      list.push_back(std::move(entry));
    }
  }
  return list.dump() + "\n";
}

}  // namespace lumaknot
