#include "cli/commands/shader_list.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scene/fields.h"
#include "scene/presets.h"
#include "shaders/languages/emit.h"
#include "system/known.h"

namespace lumaknot::cli {
namespace {

using Json = nlohmann::ordered_json;

ShaderJob job_of(const std::string& name, ShadingFrequency rate) {
  ShaderJob job;
  job.name = name;
  job.shot = {"final", Stage::kFinal, known(with_formula(job.view.material, name))};
  job.shot.material.rate = rate;
  return job;
}

/// "yes", "pixel" if light can't be computed per vertex, or "no".
std::string_view cell(const std::string& name, Language language) {
  if (emission_shortfall(job_of(name, ShadingFrequency::kPixel), language)) return "no";
  return emission_shortfall(job_of(name, ShadingFrequency::kVertex), language) ? "pixel" : "yes";
}

}  // namespace

std::string shader_list_text() {
  std::string text = fmt::format("{:<28} {:>4}", "shader", "ops");
  for (const Language language : languages())
    text += fmt::format("  {}", backend_of(language).name);
  text += "\n";
  for (const std::string& name : formula_names()) {
    const int operations = operation_count(make_shader(job_of(name, ShadingFrequency::kPixel)));
    text += fmt::format("{:<28} {:>4}", name, operations);
    for (const Language language : languages()) {
      text += fmt::format("  {:<{}}", cell(name, language), backend_of(language).name.size());
    }
    while (text.ends_with(' ')) text.pop_back();
    text += "\n";
  }
  return text +
         "\nops: operations per pixel with one white point light. yes: light per pixel or vertex.\n"
         "pixel: no --rate vertex, as the language has no vertex stage.\n"
         "Every shader takes --light, --gamut and --gated.\n";
}

std::string shader_list_json() {
  Json list = Json::array();
  for (const std::string& name : formula_names()) {
    for (const ShadingFrequency rate : {ShadingFrequency::kPixel, ShadingFrequency::kVertex}) {
      const ShaderJob job = job_of(name, rate);
      Json entry{{"shader", name},
                 {"rate", kFrequencyNames[std::size_t(rate)]},
                 {"operations", operation_count(make_shader(job))},
                 {"languages", Json::array()},
                 {"impossible", Json::object()}};
      for (const Language language : languages()) {
        const auto why = emission_shortfall(job, language);
        if (why) entry["impossible"][std::string(backend_of(language).name)] = *why;
        if (!why) entry["languages"].push_back(backend_of(language).name);
      }
      list.push_back(std::move(entry));
    }
  }
  return list.dump() + "\n";
}

}  // namespace lumaknot::cli
